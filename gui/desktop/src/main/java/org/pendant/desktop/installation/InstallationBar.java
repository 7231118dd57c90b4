package org.pendant.desktop.installation;

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
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;
import org.pendant.script.vm.ProgramState;

/** Installation bar: which installation it is, what can be done with it, and what it waits for. */
final class InstallationBar {
  private final ActiveInstallation active;
  private final Editing editing;
  private final DocumentName name = new DocumentName("installation-name");
  private final JButton save = new JButton("Save");
  private final JButton undo = new JButton("Undo");
  private final JButton redo = new JButton("Redo");
  private final Remark waiting = new Remark("installation-waiting", Palette::warning);
  private final JButton stop = new JButton("Stop program");
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8 12 4 12, gap 8 4, hidemode 3", "[grow, fill][]"));

  InstallationBar(Workbench workbench, ActiveInstallation active, Editing editing) {
    this.active = active;
    this.editing = editing;
    JPanel row = new JPanel(new WrappingRow(PartsForm.BETWEEN));
    row.add(name);
    for (List<String> each :
        List.of(
            List.of("new", "New", "New installation"),
            List.of("open", "Open\u2026", "Open an installation"),
            List.of("save", "Save", "Save the installation"),
            List.of("save-as", "Save as\u2026", "Save the installation in another file"))) {
      JButton button = each.getFirst().equals("save") ? save : new JButton(each.get(1));
      TitledCard.named(button, "installation-" + each.getFirst(), each.get(2));
      TitledCard.compact(button);
      button.addActionListener(event -> workbench.actions().run("installation." + each.getFirst()));
      row.add(button);
    }
    TitledCard.named(undo, "installation-undo", "Undo the last change (Ctrl+Z)");
    undo.addActionListener(event -> editing.undo());
    TitledCard.named(redo, "installation-redo", "Make it again (Ctrl+Y)");
    redo.addActionListener(event -> editing.redo());
    TitledCard.named(
        stop, "installation-stop", "Stop the program, so that the controller is set up anew");
    stop.addActionListener(
        event -> {
          var _ = workbench.session().submit(new ProgramCommand.StopProgram());
        });
    TitledCard.compact(undo, redo, stop);
    row.add(undo);
    row.add(redo);
    panel.add(row, "span, growx, wmin 0, wrap");
    panel.add(waiting, Remark.LAYOUT);
    stop.setVisible(false);
    panel.add(stop);
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
            .orElse("Not saved yet"));
    name.getAccessibleContext()
        .setAccessibleName(
            "Installation " + active.document().name() + (modified ? ", not saved" : ""));
    save.setEnabled(modified || active.document().file().isEmpty());
    undo.setEnabled(editing.canUndo());
    redo.setEnabled(editing.canRedo());
  }

  void refresh(ControllerState state) {
    String why =
        active.problem().isEmpty()
            ? active.waiting().isEmpty()
                ? ""
                : "The controller is not set up so yet: " + active.waiting()
            : "The file is not used: " + active.problem();
    waiting.say(why);
    stop.setVisible(!active.waiting().isEmpty() && state.program().state() != ProgramState.STOPPED);
  }
}
