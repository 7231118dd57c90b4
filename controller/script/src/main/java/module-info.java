/** URScript at work: values, compiler, virtual machine, debugger, for any host. */
module org.pendant.script {
  requires transitive org.pendant.language;
  requires transitive org.pendant.models;
  requires org.pendant.text;

  exports org.pendant.script.coverage;
  exports org.pendant.script.debug;
  exports org.pendant.script.function;
  exports org.pendant.script.value;
  exports org.pendant.script.variables;
  exports org.pendant.script.vm;
}
