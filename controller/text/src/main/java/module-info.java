/** What is said to people, in their language. */
module org.pendant.text {
  exports org.pendant.text;
}
