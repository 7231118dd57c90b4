package org.pendant.desktop.debug;

import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.project.program.script.GeneratedNames;

/**
 * Run script: a text that is started, and what it has to do with the one that people see.
 *
 * @param shown the text that people saw when it was started
 * @param lines of both
 * @param turnLine a line that the main program comes to once in each of its turns, and on which no
 *     breakpoint is set; 0 if there is none
 * @param turnsBefore how many turns begin before it comes there first
 * @param names that it has besides those that people gave
 */
public record RunScript(
    Source source,
    String shown,
    RunLines lines,
    int turnLine,
    int turnsBefore,
    GeneratedNames names) {
  /** A text that runs as people see it. */
  public static RunScript whole(Source source) {
    return new RunScript(
        source, ByteText.decoded(source.text()), RunLines.SAME, 0, 0, GeneratedNames.NONE);
  }
}
