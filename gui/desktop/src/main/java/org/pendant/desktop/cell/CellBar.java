package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.form.DocumentName;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.ButtonKeys;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;

/** Cell bar: which scene it is, what can be done with it, and whether it is around the arm. */
final class CellBar {
  private static final String APPLY = "scene-file.apply";

  private final Workbench workbench;
  private final SceneDraft draft;
  private final DocumentName name = new DocumentName("cell-name");
  private final JButton save = new JButton(text("save"));
  private final JButton apply = new JButton(text("apply"));
  private final JButton undo = new JButton(text("undo"));
  private final JButton redo = new JButton(text("redo"));
  private final Remark waiting = new Remark("cell-waiting", Palette::warning);
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8 12 4 12, gap 8 4, hidemode 3", "[grow, fill]"));

  CellBar(Workbench workbench, SceneDraft draft) {
    this.workbench = workbench;
    this.draft = draft;
    JPanel row = new JPanel(new WrappingRow(PartsForm.BETWEEN));
    row.add(name);
    for (List<String> each :
        List.of(
            List.of("new", text("newLabel"), text("newScene")),
            List.of("open", text("openLabel"), text("openAScene")),
            List.of("save", text("save"), text("saveTheScene")),
            List.of("save-as", text("saveAs"), text("saveTheSceneInAnotherFile")),
            List.of("apply", text("apply"), text("putThisSceneAroundTheArm")))) {
      JButton button =
          switch (each.getFirst()) {
            case "save" -> save;
            case "apply" -> apply;
            default -> new JButton(each.get(1));
          };
      TitledCard.named(button, "cell-" + each.getFirst(), each.get(2));
      TitledCard.compact(button);
      button.addActionListener(event -> workbench.actions().run("scene-file." + each.getFirst()));
      row.add(button);
    }
    TitledCard.named(undo, "cell-undo", text("undoTheLastChangeCtrlZ"));
    undo.addActionListener(event -> draft.undo());
    TitledCard.named(redo, "cell-redo", text("makeItAgainCtrlY"));
    redo.addActionListener(event -> draft.redo());
    TitledCard.compact(undo, redo);
    row.add(WrappingRow.together(PartsForm.BETWEEN, undo, redo));
    panel.add(row, "growx, wmin 0, wrap");
    panel.add(new RemarkSpace(1, waiting), Remark.LAYOUT);
  }

  JComponent component() {
    return panel;
  }

  /** Shows what the draft is. */
  void show() {
    ProgramDocument document = draft.document();
    name.show(document.name(), document.modified());
    name.setToolTipText(
        document.file().map(file -> file.toAbsolutePath().toString()).orElse(text("notSavedYet")));
    name.getAccessibleContext()
        .setAccessibleName(text(document.modified() ? "sceneNotSaved" : "scene", document.name()));
    enable(save, document.modified() || document.file().isEmpty());
    enable(undo, draft.canUndo());
    enable(redo, draft.canRedo());
  }

  /** Keys of a button that is disabled go to the screen, not to the button beside it. */
  private void enable(JButton button, boolean enabled) {
    ButtonKeys.enable(button, enabled, () -> workbench.show(CellView.ID));
  }

  /** Shows whether the draft is around the arm. */
  void refresh() {
    boolean waits =
        workbench.actions().all().stream()
            .anyMatch(each -> each.id().equals(APPLY) && each.enabled().getAsBoolean());
    enable(apply, waits);
    waiting.say(waits ? text("the3dViewShowsYourChanges") : "");
  }
}
