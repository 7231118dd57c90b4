package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JTextField;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneFile;
import org.pendant.kit.form.Remark;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class MeshDialogTest {
  private static final String PYRAMID =
      "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 30 20 20\n"
          + "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

  @TempDir Path folder;
  private final SceneDraft draft = new SceneDraft();
  private final List<String> taken = new ArrayList<>();
  private final BlockingQueue<String> said = new LinkedBlockingQueue<>();
  private JFileChooser chooser;
  private boolean closed;

  @BeforeEach
  void open() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    Files.writeString(folder.resolve("pyramid.obj"), PYRAMID);
    Files.writeString(folder.resolve("open.obj"), PYRAMID.replace("f 2 3 5\n", ""));
    Path scene = Files.writeString(folder.resolve("a.scene.json"), "{}");
    SceneFile read = SceneFile.read(scene);
    run(
        () -> {
          draft.open(read);
          chooser =
              new MeshDialog(
                      draft,
                      () -> {
                        closed = true;
                        said.add("closed");
                      },
                      (name, part, massKg) ->
                          taken.add(name + " " + part.unit().word() + " " + massKg))
                  .component();
          for (Remark remark : all(chooser, Remark.class)) {
            remark.getDocument().addDocumentListener(new Told(remark));
          }
        });
  }

  /** Hears every sentence. */
  private final class Told implements DocumentListener {
    private final Remark remark;

    Told(Remark remark) {
      this.remark = remark;
    }

    @Override
    public void insertUpdate(DocumentEvent event) {
      said.add(remark.getName());
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
      said.add(remark.getName());
    }

    @Override
    public void changedUpdate(DocumentEvent event) {
      // letters alone
    }
  }

  private static void run(Runnable work) throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(work);
  }

  private static <T> List<T> all(Container in, Class<T> kind) {
    List<T> found = new ArrayList<>();
    for (Component each : in.getComponents()) {
      if (kind.isInstance(each)) {
        found.add(kind.cast(each));
      }
      if (each instanceof Container container) {
        found.addAll(all(container, kind));
      }
    }
    return found;
  }

  private <T extends Component> T find(String name, Class<T> kind) {
    return all(chooser, kind).stream()
        .filter(each -> name.equals(each.getName()))
        .findFirst()
        .orElseThrow(() -> new AssertionError("there is no " + name));
  }

  private String says(String name) {
    return find(name, Remark.class).getText();
  }

  private void choose(String file) {
    chooser.setSelectedFile(folder.resolve(file).toFile());
  }

  private void unit(String word) {
    find("mesh-unit", JComboBox.class).setSelectedItem(word);
  }

  /** Waits until something is so that comes with a sentence. */
  private void await(Supplier<Boolean> wanted) throws Exception {
    boolean[] is = new boolean[1];
    run(() -> is[0] = wanted.get());
    while (!is[0]) {
      var _ = said.take();
      run(() -> is[0] = wanted.get());
    }
  }

  @Test
  void whatAFileIsShowsBeforeItIsAdded() throws Exception {
    run(
        () -> {
          choose("pyramid.obj");
          assertEquals("With a unit it can be told what is in the file.", says("mesh-facts"));
          unit("mm");
        });
    await(() -> says("mesh-facts").startsWith("6 triangles"));

    assertTrue(says("mesh-facts").contains("closed"), says("mesh-facts"));
    assertEquals("", says("mesh-problem"));
    run(chooser::approveSelection);
    await(() -> closed);
    assertEquals(List.of("pyramid mm 0.0"), taken);
  }

  @Test
  void theUnitIsAskedForAtItsField() throws Exception {
    run(
        () -> {
          choose("pyramid.obj");
          chooser.approveSelection();
        });

    assertEquals(
        "Choose the unit: the file does not say what its numbers count.",
        says("mesh-unit-problem"));
    assertFalse(closed);
  }

  @Test
  void aWrongMassIsToldAtItsFieldAndARightOneIsTaken() throws Exception {
    JTextField mass = find("mesh-mass", JTextField.class);
    run(
        () -> {
          choose("pyramid.obj");
          unit("mm");
          mass.setText("heavy");
          chooser.approveSelection();
        });
    await(() -> !says("mesh-mass-problem").isEmpty());
    assertFalse(closed);
    run(
        () -> {
          mass.setText("0.5");
          chooser.approveSelection();
        });
    await(() -> closed);

    assertEquals(List.of("pyramid mm 0.5"), taken);
  }

  @Test
  void anOpenSurfaceIsNotAddedAndTheDialogStays() throws Exception {
    run(
        () -> {
          choose("open.obj");
          unit("cm");
          chooser.approveSelection();
        });
    await(() -> says("mesh-problem").contains("is not closed: 3 edges"));

    assertTrue(says("mesh-facts").startsWith("5 triangles"), says("mesh-facts"));
    assertFalse(closed);
    assertEquals(List.of(), taken);
  }

  @Test
  void theUnitOfGltfIsKnown() throws Exception {
    Files.writeString(folder.resolve("a.gltf"), "{}");
    run(() -> choose("a.gltf"));
    await(() -> says("mesh-problem").startsWith("a.gltf: JSON:1:1: key \"asset\" is missing"));

    assertEquals("m", find("mesh-unit", JComboBox.class).getSelectedItem());
  }

  @Test
  void filesElsewhereAreRefused() throws Exception {
    run(() -> chooser.setSelectedFile(folder.resolveSibling("b.stl").toFile()));

    assertTrue(says("mesh-problem").startsWith("The file must be in the folder"));
  }
}
