package org.pendant.desktop.editor;

import java.util.Optional;
import java.util.function.BiConsumer;
import javax.swing.text.BadLocationException;
import javax.swing.text.Position;
import org.pendant.desktop.editor.text.Trail;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;

/** Navigation: returns to where the caret was before it jumped, in whichever program that was. */
final class Navigation {
  private final Programs programs;
  private final BiConsumer<ProgramDocument, Integer> show;
  private final Trail<Stop> trail = new Trail<>();

  /** A place that moves with its text; two on the same offset are the same. */
  private record Stop(ProgramDocument program, Position at) {
    @Override
    public boolean equals(Object other) {
      return other instanceof Stop stop
          && stop.program == program
          && stop.at.getOffset() == at.getOffset();
    }

    @Override
    public int hashCode() {
      return program.hashCode();
    }
  }

  /**
   * Nothing to go back to yet.
   *
   * @param show shows an offset of an open program
   */
  Navigation(Programs programs, BiConsumer<ProgramDocument, Integer> show) {
    this.programs = programs;
    this.show = show;
  }

  /** The caret of {@code editor} is about to jump away. */
  void left(ProgramEditor editor) {
    trail.left(stop(editor));
  }

  void back(ProgramEditor now) {
    go(now, trail::back);
  }

  void forward(ProgramEditor now) {
    go(now, trail::forward);
  }

  private interface Way {
    Optional<Stop> from(Stop now);
  }

  private void go(ProgramEditor now, Way way) {
    Optional<Stop> found = way.from(stop(now));
    while (found.isPresent() && !programs.all().contains(found.get().program())) {
      found = way.from(found.get());
    }
    found.ifPresent(stop -> show.accept(stop.program(), stop.at().getOffset()));
  }

  private static Stop stop(ProgramEditor editor) {
    ScriptArea area = editor.area();
    try {
      return new Stop(editor.program(), area.getDocument().createPosition(area.getCaretPosition()));
    } catch (BadLocationException e) {
      throw new IllegalStateException("the caret is in the text", e);
    }
  }
}
