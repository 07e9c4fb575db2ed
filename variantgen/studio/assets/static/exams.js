// The first page: a new exam.
import { $, post } from "./studio.js";

$("new-exam").addEventListener("submit", async event => {
  event.preventDefault();
  const form = event.currentTarget, said = form.querySelector(".error");
  try {
    location.href = (await post("/exams", Object.fromEntries(new FormData(form)))).address;
  } catch (error) {
    said.textContent = error.message; said.hidden = false;
  }
});
