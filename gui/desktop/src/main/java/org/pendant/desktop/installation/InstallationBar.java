package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.form.DocumentName;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.ButtonKeys;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;
import org.pendant.script.vm.ProgramState;

/** Installation bar: which installation it is, what can be done with it, and what it waits for. */
final class InstallationBar {
  private final ActiveInstallation active;
  private final Editing editing;
  private final Workbench workbench;
  private final DocumentName name = new DocumentName("installation-name");
  private final JButton save = new JButton(text("save"));
  private final JButton undo = new JButton(text("undo"));
  private final JButton redo = new JButton(text("redo"));
  private final Remark waiting = new Remark("installation-waiting", Palette::warning);
  private final JButton stop = new JButton(text("stopProgram"));
  private final SafetyQuestion question;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8 12 4 12, gap 8 4, hidemode 3", "[grow, fill][]"));

  InstallationBar(Workbench workbench, ActiveInstallation active, Editing editing) {
    this.workbench = workbench;
    this.active = active;
    this.editing = editing;
    JPanel row = new JPanel(new WrappingRow(PartsForm.BETWEEN));
    row.add(name);
    for (List<String> each :
        List.of(
            List.of("new", text("new"), text("newInstallation")),
            List.of("open", text("open"), text("openAnInstallation")),
            List.of("save", text("save"), text("saveTheInstallation")),
            List.of("save-as", text("saveAs"), text("saveTheInstallationInAnotherFile")))) {
      JButton button = each.getFirst().equals("save") ? save : new JButton(each.get(1));
      TitledCard.named(button, "installation-" + each.getFirst(), each.get(2));
      TitledCard.compact(button);
      button.addActionListener(event -> workbench.actions().run("installation." + each.getFirst()));
      row.add(button);
    }
    TitledCard.named(undo, "installation-undo", text("undoTheLastChangeCtrlZ"));
    undo.addActionListener(event -> undo());
    TitledCard.named(redo, "installation-redo", text("makeItAgainCtrlY"));
    redo.addActionListener(event -> redo());
    TitledCard.named(stop, "installation-stop", text("stopTheProgramSoThatThe"));
    stop.addActionListener(
        event -> {
          var _ = workbench.session().submit(new ProgramCommand.StopProgram());
        });
    TitledCard.compact(undo, redo, stop);
    row.add(WrappingRow.together(PartsForm.BETWEEN, undo, redo));
    panel.add(row, "span, growx, wmin 0, wrap");
    panel.add(waiting, Remark.LAYOUT);
    stop.setVisible(false);
    panel.add(stop);
    question = new SafetyQuestion(row, "installation-safety");
  }

  /** Undoes the last change; asks first if that changes the safety configuration. */
  void undo() {
    turn(editing.undoneSafety(), text("undoAndPowerOff"), editing::undo, undo);
  }

  /** Makes the last change that was undone again; asks as {@link #undo} does. */
  void redo() {
    turn(editing.redoneSafety(), text("redoAndPowerOff"), editing::redo, redo);
  }

  private void turn(List<String> changes, String words, Runnable turn, JButton from) {
    if (changes.isEmpty()) {
      turn.run();
    } else {
      question.ask(changes, words, turn, from);
    }
  }

  JComponent component() {
    return panel;
  }

  void show() {
    boolean modified = active.document().modified();
    name.show(active.document().name(), modified);
    name.setToolTipText(
        active
            .document()
            .file()
            .map(file -> file.toAbsolutePath().toString())
            .orElse(text("notSavedYet")));
    name.getAccessibleContext()
        .setAccessibleName(
            text(
                modified ? "installationNotSaved" : "installationNamed", active.document().name()));
    enable(save, modified || active.document().file().isEmpty());
    enable(undo, editing.canUndo());
    enable(redo, editing.canRedo());
    // what was asked is not what would change now
    question.close();
  }

  /** Keys of a button that is disabled go to the screen, not to the button beside it. */
  private void enable(JButton button, boolean enabled) {
    ButtonKeys.enable(button, enabled, () -> workbench.show(InstallationView.ID));
  }

  void refresh(ControllerState state) {
    String why =
        active.problem().isEmpty()
            ? active.waiting().isEmpty() ? "" : text("theControllerIsNotSetUp", active.waiting())
            : text("theFileIsNotUsed", active.problem());
    waiting.say(why);
    stop.setVisible(!active.waiting().isEmpty() && state.program().state() != ProgramState.STOPPED);
  }
}
