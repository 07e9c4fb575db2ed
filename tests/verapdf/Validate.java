import java.io.FileInputStream;
import org.verapdf.gf.foundry.VeraGreenfieldFoundryProvider;
import org.verapdf.pdfa.Foundries;
import org.verapdf.pdfa.PDFAParser;
import org.verapdf.pdfa.PDFAValidator;
import org.verapdf.pdfa.flavours.PDFAFlavour;
import org.verapdf.pdfa.results.TestAssertion;
import org.verapdf.pdfa.results.ValidationResult;

/** Validates pairs of a flavour and a file: prints a line for each of them, then one for each assertion that failed. */
public class Validate {
    private static final int MOST_FAILURES = 50;

    public static void main(String[] arguments) throws Exception {
        VeraGreenfieldFoundryProvider.initialise();
        for (int i = 0; i < arguments.length; i += 2) {
            validate(PDFAFlavour.fromString(arguments[i]), arguments[i + 1]);
        }
    }

    private static void validate(PDFAFlavour flavour, String path) throws Exception {
        try (PDFAParser parser = Foundries.defaultInstance().createParser(new FileInputStream(path), flavour);
             PDFAValidator validator =
                 Foundries.defaultInstance().createValidator(flavour, MOST_FAILURES, false, false, false)) {
            ValidationResult result = validator.validate(parser);
            System.out.println("FILE\t" + flavour.getId() + "\t" + result.getTotalAssertions() + "\t" + path);
            for (TestAssertion found : result.getTestAssertions()) {
                if (found.getStatus() == TestAssertion.Status.FAILED) {
                    System.out.println("FAILED\t" + found.getRuleId().getClause() + "-" + found.getRuleId().getTestNumber());
                }
            }
        }
    }
}
