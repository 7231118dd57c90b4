package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import org.eclipse.lsp4j.debug.Source;
import org.eclipse.lsp4j.debug.SourcePresentationHint;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.SourceRange;
import org.pendant.script.vm.Program;

/** Debugged text: the text that is debugged, with places as the client counts them. */
final class DebuggedText {
  /** What a text is called that no file has: the script of a tree. */
  static final int GENERATED = 1;

  private final ClientForm form;
  private final org.pendant.language.source.Source source;
  private final Optional<Path> file;

  /**
   * A place.
   *
   * @param line as the client counts
   * @param column as the client counts
   */
  record Place(int line, int column) {}

  private final boolean known;

  /** Where it comes from, if no file has it. */
  private final String origin;

  DebuggedText(ClientForm form, DebugTarget target) {
    this(
        form,
        target.source().orElseThrow(),
        target.generated()
            ? Optional.empty()
            : Optional.of(Path.of(target.source().orElseThrow().name())),
        true,
        text("madeOfTree"));
  }

  /**
   * A text.
   *
   * @param file that has it; empty for none
   */
  DebuggedText(ClientForm form, org.pendant.language.source.Source source, Optional<Path> file) {
    this(form, source, file, true, text("sentToRobot"));
  }

  private DebuggedText(
      ClientForm form,
      org.pendant.language.source.Source source,
      Optional<Path> file,
      boolean known,
      String origin) {
    this.origin = origin;
    this.form = form;
    this.source = source;
    this.file = file;
    this.known = known;
  }

  /** Stands for that of a program which will begin: any text may be meant. */
  static DebuggedText unknown(ClientForm form) {
    return new DebuggedText(
        form,
        org.pendant.language.source.Source.of(text("noProgram"), ""),
        Optional.empty(),
        false,
        "");
  }

  /** Whether there is a program. */
  boolean known() {
    return known;
  }

  org.pendant.language.source.Source source() {
    return source;
  }

  /** What the protocol calls it. */
  Source asSource() {
    Source named = new Source();
    if (file.isPresent()) {
      named.setName(String.valueOf(file.get().getFileName()));
      named.setPath(form.name(file.get()));
    } else {
      named.setName(source.name());
      named.setSourceReference(GENERATED);
      named.setOrigin(form.shown(origin));
      named.setPresentationHint(SourcePresentationHint.NORMAL);
    }
    return named;
  }

  /** Whether a client means this text. */
  boolean isMeant(Source named) {
    if (!known) {
      return true;
    }
    if (named.getSourceReference() != null && named.getSourceReference() > 0) {
      return file.isEmpty() && named.getSourceReference() == GENERATED;
    }
    return named.getPath() != null
        && file.isPresent()
        && form.file(named.getPath()).filter(other -> same(file.get(), other)).isPresent();
  }

  private static boolean same(Path one, Path other) {
    try {
      return Files.isSameFile(one, other);
    } catch (IOException e) {
      return one.toAbsolutePath().normalize().equals(other.toAbsolutePath().normalize());
    }
  }

  /** Where an offset is. */
  Place place(int offset) {
    int at = Math.min(offset, source.text().length());
    int line = source.line(at);
    String before = source.text().substring(source.lineStart(line), at);
    return new Place(form.line(line), form.column(ByteText.decoded(before).length() + 1));
  }

  /** Where the text of a range begins. */
  Place start(SourceRange range) {
    return place(range.start());
  }

  /** The line, counted from 1, on which a breakpoint of {@code line} stops; empty for nowhere. */
  OptionalInt statementLine(Program program, int line) {
    OptionalInt start = program.statementFrom(line);
    return start.isPresent() ? OptionalInt.of(source.line(start.getAsInt())) : start;
  }

  ClientForm form() {
    return form;
  }
}
