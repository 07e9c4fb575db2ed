"""The key and a form for marking as workbooks. These modules need XlsxWriter: import them where they are used."""
