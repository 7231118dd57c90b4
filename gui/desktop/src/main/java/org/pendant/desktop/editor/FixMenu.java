package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.EventQueue;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.PointerInfo;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.AnalysisSchedule;
import org.pendant.desktop.editor.text.Edit;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.text.Messages;
import org.pendant.language.service.QuickFix;
import org.pendant.language.source.ByteText;

/**
 * Fix menu: offers the quick fixes at the caret: as a menu when asked, and as a light bulb by
 * itself.
 */
final class FixMenu {
  private final ScriptArea area;
  private final AnalysisSchedule schedule;
  private final WorkQueue background;
  private final GutterMarks marks;
  private final EditorHost editorHost;
  private int bulbFor = -1;

  FixMenu(
      ScriptArea area,
      AnalysisSchedule schedule,
      WorkQueue background,
      GutterMarks marks,
      EditorHost editorHost) {
    this.area = area;
    this.schedule = schedule;
    this.background = background;
    this.marks = marks;
    this.editorHost = editorHost;
  }

  /** Opens the menu at the caret. */
  void open() {
    schedule.whenCurrent(
        analysed -> find(analysed, area.getCaretPosition(), fixes -> show(analysed, fixes)));
  }

  /** Opens the menu for one problem. */
  void open(Problem problem) {
    area.show(problem.span());
    open();
  }

  /** Shows or hides the bulb after the caret moved or the text was analysed. */
  void refreshBulb() {
    int caret = area.getCaretPosition();
    boolean wanted =
        area.analysed().filter(analysed -> !analysed.problemsAt(caret).isEmpty()).isPresent();
    int line = wanted ? area.lineAt(caret) : 0;
    if (line == 0) {
      bulbFor = -1;
      marks.setBulb(0);
      return;
    }
    area.analysed()
        .filter(analysed -> bulbFor != caret)
        .ifPresent(
            analysed -> {
              bulbFor = caret;
              find(analysed, caret, fixes -> marks.setBulb(fixes.isEmpty() ? 0 : line));
            });
  }

  /** The text is another: what was found for the caret's place no longer counts. */
  void forget() {
    bulbFor = -1;
  }

  private interface Found extends java.util.function.Consumer<List<QuickFix>> {}

  private void find(AnalysedText analysed, int caret, Found found) {
    List<Problem> problems = analysed.problemsAt(caret);
    background.run(
        0,
        () -> {
          List<QuickFix> fixes = new ArrayList<>();
          problems.forEach(problem -> fixes.addAll(analysed.fixes(problem)));
          EventQueue.invokeLater(
              () -> {
                if (schedule.current().filter(now -> now == analysed).isPresent()) {
                  found.accept(fixes);
                }
              });
        });
  }

  private void show(AnalysedText analysed, List<QuickFix> fixes) {
    if (fixes.isEmpty()) {
      editorHost.tell(text("thereIsNoQuickFixHere"));
      return;
    }
    JPopupMenu menu = new JPopupMenu();
    menu.setName("quick-fixes");
    PointerInfo info = MouseInfo.getPointerInfo();
    Point pointer = info == null ? new Point() : info.getLocation();
    BiConsumer<QuickFix, List<Edit>> item =
        (fix, edits) -> {
          JMenuItem entry = new StillItem(Messages.shown(ByteText.decoded(fix.title())), pointer);
          entry.addActionListener(event -> area.make(edits));
          menu.add(entry);
        };
    fixes.forEach(fix -> item.accept(fix, analysed.edits(fix.edits())));
    Rectangle place = area.place(area.getCaretPosition());
    menu.show(area, place.x, place.y + place.height);
    // ENTER takes the first; selecting it in the menu alone would only paint it so.
    MenuSelectionManager.defaultManager()
        .setSelectedPath(new MenuElement[] {menu, (MenuElement) menu.getComponent(0)});
  }
}
