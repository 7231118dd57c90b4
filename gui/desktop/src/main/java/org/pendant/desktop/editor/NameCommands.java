package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.EventQueue;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.SwingUtilities;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.Place;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.text.Messages;
import org.pendant.language.service.RenameResult;
import org.pendant.language.source.ByteText;

/**
 * Name commands: what can be done with the name at the caret: find where it comes from, its uses,
 * rename it.
 */
final class NameCommands {
  private final ScriptArea area;
  private final ProgramDocument program;
  private final AnalysisSchedule schedule;
  private final WorkQueue background;
  private final EditorHost editorHost;
  private final Runnable leaving;

  /**
   * What can be done with names of one text.
   *
   * @param leaving told before the caret jumps away
   */
  NameCommands(
      ScriptArea area,
      ProgramDocument program,
      AnalysisSchedule schedule,
      WorkQueue background,
      EditorHost editorHost,
      Runnable leaving) {
    this.area = area;
    this.program = program;
    this.schedule = schedule;
    this.background = background;
    this.editorHost = editorHost;
    this.leaving = leaving;
    area.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)
                && event.isControlDown()
                && event.getClickCount() == 1) {
              goToDefinition();
            }
          }
        });
  }

  /** Moves the caret to where the name is defined or first assigned. */
  void goToDefinition() {
    schedule.whenCurrent(
        analysed -> {
          int caret = area.getCaretPosition();
          analysed
              .definition(caret)
              .ifPresentOrElse(
                  found -> {
                    leaving.run();
                    area.show(found);
                  },
                  () ->
                      editorHost.tell(
                          analysed
                              .hover(caret)
                              .map(hover -> text("isBuiltIn", ByteText.decoded(hover.head())))
                              .orElse(text("thereIsNoNameHere"))));
        });
  }

  /** Lists every place that means the same. */
  void findReferences() {
    schedule.whenCurrent(
        analysed -> {
          List<TextSpan> spans = analysed.references(area.getCaretPosition());
          if (spans.isEmpty()) {
            editorHost.tell(text("thereIsNoNameHere"));
            return;
          }
          String name = area.text(spans.getFirst());
          List<Place> places =
              spans.stream()
                  .map(span -> Place.of(program.name(), program.file(), analysed.text(), span))
                  .toList();
          editorHost.list(
              text(places.size() == 1 ? "onePlaceOf" : "placesOf", name, places.size()), places);
        });
  }

  /** Asks for another name, and gives it everywhere. */
  void rename() {
    schedule.whenCurrent(
        analysed -> {
          int caret = area.getCaretPosition();
          List<TextSpan> spans = analysed.references(caret);
          spans.stream()
              .filter(span -> span.touches(caret))
              .findFirst()
              .ifPresentOrElse(
                  span -> askForName(span), () -> editorHost.tell(text("thereIsNoNameHere")));
        });
  }

  private void askForName(TextSpan span) {
    String old = area.text(span);
    InlinePrompt.ask(
        area,
        area.place(span.start()),
        text("newNameFor", old),
        old,
        prompt -> {
          if (prompt.text().equals(old)) {
            prompt.close();
            return;
          }
          schedule.whenCurrent(analysed -> rename(analysed, span.start(), prompt));
        });
  }

  private void rename(AnalysedText analysed, int offset, InlinePrompt prompt) {
    String name = ByteText.asBytes(prompt.text());
    background.run(
        0,
        () -> {
          RenameResult result = analysed.analysis().rename(analysed.toByte(offset), name);
          EventQueue.invokeLater(() -> finish(analysed, result, prompt));
        });
  }

  private void finish(AnalysedText analysed, RenameResult result, InlinePrompt prompt) {
    if (schedule.current().filter(now -> now == analysed).isEmpty()) {
      prompt.refuse(text("theTextHasChangedMeanwhilePress"));
      return;
    }
    switch (result) {
      case RenameResult.Refused refused ->
          prompt.refuse(Messages.shown(ByteText.decoded(refused.reason())));
      case RenameResult.Renamed renamed -> {
        prompt.close();
        area.make(analysed.edits(renamed.edits()));
        int places = renamed.edits().size();
        editorHost.tell(text(places == 1 ? "renamedInOnePlace" : "renamedInPlaces", places));
      }
    }
  }
}
