/** Tests of robot programs: found, run in virtual time, and reported. */
module org.pendant.testing {
  requires java.xml;
  requires org.pendant.motion;
  requires transitive org.pendant.controller;
  requires transitive org.pendant.language;
  requires transitive org.pendant.project;
  requires transitive org.pendant.script;
  requires org.pendant.text;

  exports org.pendant.testing.builtin;
  exports org.pendant.testing.coverage.report;
  exports org.pendant.testing.coverage;
  exports org.pendant.testing.mutation.report;
  exports org.pendant.testing.mutation;
  exports org.pendant.testing.remote;
  exports org.pendant.testing.report;
  exports org.pendant.testing.run;
  exports org.pendant.testing.source;
  exports org.pendant.testing;
}
