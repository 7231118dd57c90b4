/**
 * URScript as text: source positions, grammar, syntax tree, checker, signatures, editor service.
 */
module org.pendant.language {
  requires transitive org.antlr.antlr4.runtime;
  requires org.pendant.text;

  exports org.pendant.language.check;
  exports org.pendant.language.parse;
  exports org.pendant.language.service;
  exports org.pendant.language.signature;
  exports org.pendant.language.source;
  exports org.pendant.language.syntax;
}
