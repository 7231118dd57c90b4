package org.pendant.desktop.shell;

import java.util.Optional;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;

/**
 * Received program: the text of a program that a client sent to a port, open among the programs so
 * that people can see where it is, set breakpoints in it and save it. There is one at most: the
 * next one takes its place.
 */
final class ReceivedProgram {
  /** Longer ones are not shown: nobody reads them, and the editor would be busy with them. */
  private static final int MAX_CHARACTERS = 1_000_000;

  private final Programs programs;
  private Optional<ProgramDocument> shown = Optional.empty();

  ReceivedProgram(Programs programs) {
    this.programs = programs;
  }

  /** Shows another one, behind the program in front; the document that has it. */
  Optional<ProgramDocument> show(Optional<Source> source) {
    Optional<ProgramDocument> before = shown().filter(ProgramDocument::received);
    shown =
        source
            .filter(each -> each.text().length() <= MAX_CHARACTERS)
            .map(each -> open(each, before));
    before.filter(each -> !shown.equals(Optional.of(each))).ifPresent(this::close);
    return shown;
  }

  private ProgramDocument open(Source source, Optional<ProgramDocument> before) {
    String name = nameOf(source);
    String text = ByteText.decoded(source.text()).replace("\r\n", "\n").replace('\r', '\n');
    ProgramDocument document =
        before
            .filter(each -> each.name().equals(name))
            .orElse(ProgramDocument.received(name, text));
    document.setText(text);
    programs.open(document);
    return document;
  }

  private static String nameOf(Source source) {
    String name = ByteText.decoded(source.name());
    return name.endsWith(ProgramDocument.SCRIPT) ? name : name + ProgramDocument.SCRIPT;
  }

  private void close(ProgramDocument before) {
    boolean front = programs.current() == before;
    programs.close(before, ProgramDocument.untitled("untitled.script", ""));
    if (front) {
      shown.ifPresent(programs::select);
    }
  }

  /** What is shown, as long as people have not closed it. */
  Optional<ProgramDocument> shown() {
    return shown.filter(programs.all()::contains);
  }
}
