/** Recordings of runs, and runs that are repeated from them. */
module org.pendant.recording {
  requires transitive org.pendant.controller;
  requires transitive org.pendant.language;
  requires transitive org.pendant.models;
  requires transitive org.pendant.motion;
  requires transitive org.pendant.script;
  requires org.pendant.text;

  exports org.pendant.recording;
  exports org.pendant.recording.compare;
  exports org.pendant.recording.explain;
  exports org.pendant.recording.fit;
  exports org.pendant.recording.lines;
  exports org.pendant.recording.replay;
  exports org.pendant.recording.whatif;
}
