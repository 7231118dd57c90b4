/** Robots in JUnit tests: the extension that others depend on. */
module org.pendant.junit {
  requires transitive org.junit.jupiter.api;
  requires transitive org.pendant.controller;
  requires transitive org.pendant.language;
  requires transitive org.pendant.project;
  requires transitive org.pendant.recording;
  requires transitive org.pendant.script;

  exports org.pendant.junit;
}
