package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.awt.Dimension;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.world.MeshPart;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.background.Background;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;
import org.pendant.models.mesh.MeshFile;
import org.pendant.models.mesh.MeshUnit;

/**
 * Mesh dialog: asks for a file of triangles, for its unit, which most files do not say, and for a
 * mass, while the window behind it can be used. It tells what a file is before it is added, and
 * what is wrong beside the field that it is wrong in.
 */
final class MeshDialog {
  private static final String TITLE = text("addMesh");
  private static final String NO_UNIT = text("chooseUnit");

  private final SceneDraft draft;
  private final Runnable close;
  private final Taker chosen;
  private final JFileChooser chooser;
  private final JComboBox<String> unit = new JComboBox<>();
  private final JTextField mass = new JTextField();
  private final Remark facts = new Remark("mesh-facts", Palette::quiet);
  private final Remark fileProblem = new Remark("mesh-problem", Palette::error);
  private final Remark unitProblem = new Remark("mesh-unit-problem", Palette::error);
  private final Remark massProblem = new Remark("mesh-mass-problem", Palette::error);

  /** What was asked for last; answers to others come too late. */
  private Optional<MeshChoice> looking = Optional.empty();

  private MeshChoice.Facts known = MeshChoice.Facts.NONE;
  private boolean adding;

  /** Takes what was chosen. */
  @FunctionalInterface
  interface Taker {
    /**
     * Takes it.
     *
     * @param name of the file without its ending
     * @param massKg 0 for what stands still
     */
    void take(String name, MeshPart part, double massKg);
  }

  /**
   * The content of a dialog.
   *
   * @param close shuts it
   */
  MeshDialog(SceneDraft draft, Runnable close, Taker chosen) {
    this.draft = draft;
    this.close = close;
    this.chosen = chosen;
    chooser = new JFileChooser(folder().map(Path::toFile).orElse(null));
    chooser.setName("mesh-dialog");
    chooser.getAccessibleContext().setAccessibleName(TITLE);
    chooser.setFileFilter(
        new FileNameExtensionFilter(
            text("meshesStlObjGltf"), MeshFile.ENDINGS.toArray(String[]::new)));
    chooser.setApproveButtonText(text("add"));
    chooser.setAccessory(side());
    chooser.addPropertyChangeListener(JFileChooser.SELECTED_FILE_CHANGED_PROPERTY, event -> look());
    chooser.addActionListener(
        event -> {
          if (event.getActionCommand().equals(JFileChooser.APPROVE_SELECTION)) {
            add();
          } else {
            close.run();
          }
        });
    unit.addActionListener(event -> look());
    if (folder().isEmpty()) {
      fileProblem.say(choice().missing());
    }
  }

  private JPanel side() {
    TitledCard.named(unit, "mesh-unit", text("unitOfTheNumbersInThe"));
    unit.addItem(NO_UNIT);
    for (MeshUnit each : MeshUnit.values()) {
      unit.addItem(each.word());
    }
    TitledCard.named(mass, "mesh-mass", text("massInKgEmptyForWhat"));
    JPanel side =
        new JPanel(new MigLayout("insets 0 12 0 0, wrap, hidemode 3, width 270!", "[grow, fill]"));
    side.add(label(text("unitOfTheFile"), unit));
    side.add(unit);
    side.add(unitProblem, Remark.LAYOUT);
    side.add(label(text("massKgEmptyStandsStill"), mass), "gaptop 4");
    side.add(mass);
    side.add(massProblem, Remark.LAYOUT);
    side.add(facts, Remark.LAYOUT + ", gaptop 8");
    side.add(fileProblem, Remark.LAYOUT);
    return side;
  }

  private static JLabel label(String text, JComponent of) {
    JLabel label = new JLabel(text);
    label.setLabelFor(of);
    return label;
  }

  /** Opens the dialog. */
  static void show(Component parent, SceneDraft draft, Taker chosen) {
    JDialog dialog =
        new JDialog(SwingUtilities.getWindowAncestor(parent), TITLE, ModalityType.MODELESS);
    MeshDialog content = new MeshDialog(draft, dialog::dispose, chosen);
    dialog.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            content.chooser.cancelSelection();
          }
        });
    dialog.add(content.chooser);
    // room for what is wrong beside the files
    dialog.setPreferredSize(new Dimension(UIScale.scale(820), UIScale.scale(540)));
    dialog.pack();
    dialog.setLocationRelativeTo(parent);
    dialog.setVisible(true);
  }

  /** The chooser, with all fields in it. */
  JFileChooser component() {
    return chooser;
  }

  private Optional<Path> folder() {
    return draft.document().onDisk().map(SavedProgram::path).map(Path::getParent);
  }

  private MeshChoice choice() {
    return new MeshChoice(
        folder(),
        Optional.ofNullable(chooser.getSelectedFile())
            .map(File::toPath)
            .map(path -> path.toAbsolutePath().normalize()),
        MeshUnit.of(String.valueOf(unit.getSelectedItem())));
  }

  /** Tells what the chosen file is, as far as that can be known. */
  private void look() {
    MeshChoice now = choice();
    if (looking.equals(Optional.of(now))) {
      return;
    }
    looking = Optional.of(now);
    known = MeshChoice.Facts.NONE;
    adding = false;
    facts.say("");
    unitProblem.say("");
    massProblem.say("");
    fileProblem.say(now.file().isEmpty() ? "" : now.missing());
    if (now.missing().isEmpty() && now.unit().isEmpty() && now.knownUnit().isPresent()) {
      // asks for another look, with the unit that the format has
      unit.setSelectedItem(now.knownUnit().get().word());
    } else if (now.missing().isEmpty() && now.knownUnit().isPresent()) {
      facts.say(text("reading"));
      Background.run(
          now::look,
          found -> found(now, found),
          failed -> fileProblem.say(Messages.shown(failed.getMessage())));
    } else if (now.missing().isEmpty()) {
      facts.say(text("withAUnitItCanBe"));
    }
  }

  private void found(MeshChoice of, MeshChoice.Facts found) {
    if (!looking.equals(Optional.of(of))) {
      return;
    }
    known = found;
    facts.say(String.join("\n", found.lines()));
    fileProblem.say(Messages.shown(found.problem()));
    if (adding) {
      finish(of);
    }
  }

  /** Adds what was chosen, as soon as it has been read again: the file may have changed. */
  private void add() {
    looking = Optional.empty();
    look();
    MeshChoice now = choice();
    fileProblem.say(now.missing());
    if (now.missing().isEmpty()) {
      unitProblem.say(now.missingUnit());
      adding = now.knownUnit().isPresent();
      if (!adding) {
        unit.requestFocusInWindow();
      }
    }
  }

  private void finish(MeshChoice of) {
    adding = false;
    if (known.part().isEmpty()) {
      return;
    }
    MeshPart part = known.part().get();
    double massKg;
    try {
      massKg = MeshChoice.massKg(mass.getText(), part);
    } catch (IllegalArgumentException e) {
      massProblem.say(Messages.shown(e.getMessage()));
      mass.requestFocusInWindow();
      return;
    }
    close.run();
    chosen.take(of.stem(), part, massKg);
  }
}
