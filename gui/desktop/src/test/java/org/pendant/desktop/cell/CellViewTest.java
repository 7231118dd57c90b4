package org.pendant.desktop.cell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.EntryField;
import org.pendant.models.pose.Pose;

final class CellViewTest {
  private final SceneDraft draft = new SceneDraft();
  private RobotSession session;

  /** Work on the dispatch thread with the view in a window. */
  private interface Work {
    void on(CellView view);
  }

  @BeforeEach
  void start() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    session = RobotSession.start(ControllerOptions.headless());
  }

  @AfterEach
  void close() {
    if (session != null) {
      session.close();
    }
  }

  private void show(Work work) throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          FlatLaf.setup(new FlatLightLaf());
          CellView view = new CellView(new PreviewWorkbench(session), draft);
          JFrame frame = new JFrame(view.title());
          frame.add(view.component());
          frame.setSize(1024, 700);
          frame.setVisible(true);
          try {
            view.refresh(session.state());
            work.on(view);
          } finally {
            frame.dispose();
          }
        });
  }

  private static List<JComponent> all(Container in) {
    List<JComponent> found = new ArrayList<>();
    for (Component each : in.getComponents()) {
      if (each instanceof JComponent component) {
        found.add(component);
        found.addAll(all(component));
      }
    }
    return found;
  }

  private static <C extends JComponent> C find(CellView view, String name, Class<C> kind) {
    return all(view.component()).stream()
        .filter(each -> name.equals(each.getName()))
        .findFirst()
        .map(kind::cast)
        .orElseThrow(() -> new AssertionError("there is no " + name));
  }

  private static void press(CellView view, String name) {
    find(view, name, AbstractButton.class).doClick(0);
  }

  private static void type(CellView view, String name, String text) {
    JTextField field = find(view, name, JTextField.class);
    field.setText(text);
    field.postActionEvent();
  }

  @Test
  void aBoxIsAddedAndPlacedByNumbers() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-box");
          type(view, "cell-object-name", "Fixture");
          type(view, "cell-object-pose-x", "450");
          type(view, "cell-object-length-z", "60");
          SceneObject.Box box = (SceneObject.Box) draft.scene().objects().getFirst();
          assertEquals("Fixture", box.name());
          assertEquals(new Pose(0.45, 0, 0.05, 0, 0, 0), box.poseInBase());
          assertEquals(new Vector3(0.1, 0.1, 0.06), box.sizeM());
          press(view, "cell-undo");
          press(view, "cell-undo");
          assertEquals(
              0.4, ((SceneObject.Box) draft.scene().objects().getFirst()).poseInBase().x());
        });
  }

  @Test
  void theFormHasTheRowsOfTheShape() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-box");
          press(view, "cell-object-add-ball");
          assertTrue(find(view, "cell-object-radius", JTextField.class).isVisible());
          assertFalse(find(view, "cell-object-length-x", JTextField.class).isVisible());
          press(view, "cell-object-remove");
          assertFalse(find(view, "cell-object-radius", JTextField.class).isVisible());
          assertTrue(find(view, "cell-object-length-x", JTextField.class).isVisible());
        });
  }

  @Test
  void whatNoSceneCanHaveIsRefusedAtTheField() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-ball");
          JTextField radius = find(view, "cell-object-radius", JTextField.class);
          radius.setText("0");
          assertEquals("radius is 0 m, must be 0.001 to 10 m", ((EntryField) radius).refusal());
          radius.postActionEvent();
          assertEquals(0.05, ((SceneObject.Sphere) draft.scene().objects().getFirst()).radiusM());
          press(view, "cell-object-add-ball");
          JTextField name = find(view, "cell-object-name", JTextField.class);
          name.setText("Ball_1");
          assertEquals(
              "name is \"Ball_1\" again, must be another for each object",
              ((EntryField) name).refusal());
        });
  }

  @Test
  void aLoadIsHungOnTheFlange() throws Exception {
    show(
        view -> {
          press(view, "cell-load-a-load-hangs-there");
          type(view, "cell-load-mass", "2.5");
          assertEquals(2.5, draft.scene().load().orElseThrow().massKg());
          JTextField mass = find(view, "cell-load-mass", JTextField.class);
          mass.setText("500");
          assertEquals("mass is 500 kg, must be 0 to 100 kg", ((EntryField) mass).refusal());
        });
  }

  @Test
  void devicesAreWrittenAsTextAndRefusedWithTheirPlace() throws Exception {
    show(
        view -> {
          JTextArea area = find(view, "cell-equipment", JTextArea.class);
          area.setText("{\n  \"devices\": [{\"type\": \"two-fingers\"}]\n}");
          String refusal = find(view, "cell-equipment-problem", JTextArea.class).getText();
          assertTrue(refusal.startsWith("line 2, column 24: type is \"two-fingers\""), refusal);
          area.setText("{\n  \"devices\": [{\"type\": \"two-finger\"}]\n}");
          area.getActionMap().get("take").actionPerformed(null);
          assertEquals("[{\"type\": \"two-finger\"}]", draft.equipment().get("devices"));
          press(view, "cell-undo");
          assertTrue(draft.equipment().isEmpty());
          assertEquals("{\n\n}\n", area.getText());
        });
  }
}
