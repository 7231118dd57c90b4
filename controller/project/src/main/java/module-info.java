/**
 * Documents: program trees, installations, the files of PolyScope, and the scripts that they
 * become.
 */
module org.pendant.project {
  requires java.xml;
  requires tools.jackson.core;
  requires transitive org.pendant.controller;
  requires transitive org.pendant.language;
  requires transitive org.pendant.models;
  requires transitive org.pendant.script;
  requires org.pendant.text;

  exports org.pendant.project.calibration;
  exports org.pendant.project.installation.file;
  exports org.pendant.project.installation.text;
  exports org.pendant.project.polyscope.xml;
  exports org.pendant.project.program;
  exports org.pendant.project.program.check;
  exports org.pendant.project.program.file;
  exports org.pendant.project.program.script;
  exports org.pendant.project.program.text;
  exports org.pendant.project.program.urp;
}
