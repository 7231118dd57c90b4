package org.pendant.desktop.cell;

import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiConsumer;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.background.Background;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;
import org.pendant.models.mesh.MeshException;
import org.pendant.models.mesh.MeshUnit;

/**
 * Mesh dialog: asks for a file of triangles and for its unit, which the file does not say, while
 * the window behind it can be used. What is wrong with them is told in it.
 */
final class MeshDialog {
  private static final String TITLE = "Add mesh";
  private static final String NO_UNIT = "choose";

  private final SceneDraft draft;
  private final Runnable close;
  private final JFileChooser chooser;
  private final JComboBox<String> unit = new JComboBox<>();
  private final Remark problem = new Remark("mesh-problem", Palette::error);
  private final BiConsumer<String, MeshPart> chosen;

  private MeshDialog(SceneDraft draft, Runnable close, BiConsumer<String, MeshPart> chosen) {
    this.draft = draft;
    this.close = close;
    this.chosen = chosen;
    chooser = new JFileChooser(folder().map(Path::toFile).orElse(null));
    chooser.setName("mesh-dialog");
    chooser.getAccessibleContext().setAccessibleName(TITLE);
    chooser.setFileFilter(new FileNameExtensionFilter("Meshes (STL, OBJ)", "stl", "obj"));
    chooser.setApproveButtonText("Add");
    TitledCard.named(unit, "mesh-unit", "Unit of the numbers in the file");
    unit.addItem(NO_UNIT);
    for (MeshUnit each : MeshUnit.values()) {
      unit.addItem(each.word());
    }
    JPanel side = new JPanel(new MigLayout("insets 0 12 0 0, wrap, width 200!", "[grow, fill]"));
    JLabel label = new JLabel("Unit of the file");
    label.setLabelFor(unit);
    side.add(label);
    side.add(unit);
    side.add(problem, Remark.LAYOUT);
    chooser.setAccessory(side);
    chooser.addActionListener(
        event -> {
          if (event.getActionCommand().equals(JFileChooser.APPROVE_SELECTION)) {
            take(chooser.getSelectedFile().toPath().toAbsolutePath().normalize());
          } else {
            close.run();
          }
        });
    if (folder().isEmpty()) {
      problem.say("Save the scene first: meshes are files in its folder.");
    }
  }

  /**
   * Opens the dialog.
   *
   * @param chosen takes the name of the file without its ending, and its triangles
   */
  static void show(Component parent, SceneDraft draft, BiConsumer<String, MeshPart> chosen) {
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
    dialog.pack();
    dialog.setLocationRelativeTo(parent);
    dialog.setVisible(true);
  }

  private Optional<Path> folder() {
    return draft.document().onDisk().map(SavedProgram::path).map(Path::getParent);
  }

  private void take(Path file) {
    Optional<Path> folder = folder();
    Optional<MeshUnit> of = MeshUnit.of(String.valueOf(unit.getSelectedItem()));
    if (folder.isEmpty()) {
      problem.say("Save the scene first: meshes are files in its folder.");
    } else if (!file.startsWith(folder.get())) {
      problem.say("The file must be in the folder of the scene, " + folder.get() + ", or below.");
    } else if (of.isEmpty()) {
      problem.say("Choose the unit: the file does not say what its numbers count.");
      unit.requestFocusInWindow();
    } else {
      read(folder.get(), file, of.get());
    }
  }

  private void read(Path folder, Path file, MeshUnit of) {
    String name = name(folder, file);
    Background.run(
        () -> part(folder, name, of),
        part -> {
          close.run();
          chosen.accept(stem(name), part);
        },
        failed -> problem.say(name + ": " + failed.getMessage()));
  }

  private static MeshPart part(Path folder, String name, MeshUnit of) throws IOException {
    try {
      return new MeshPart(name, of, MeshFiles.in(folder).read(name, of));
    } catch (MeshException | IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /** The name of a file as scenes have it. */
  private static String name(Path folder, Path file) {
    return folder.relativize(file).toString().replace('\\', '/');
  }

  /** What an object of it is called. */
  private static String stem(String name) {
    String last = name.substring(name.lastIndexOf('/') + 1);
    int dot = last.lastIndexOf('.');
    String stem = dot > 0 ? last.substring(0, dot) : last;
    return stem.length() > 40 ? stem.substring(0, 40) : stem;
  }
}
