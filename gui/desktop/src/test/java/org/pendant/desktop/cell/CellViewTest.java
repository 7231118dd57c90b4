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
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.cell.BodyRail;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DoorLeaf;
import org.pendant.controller.world.GripperSetup;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.session.SharedCell;
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
          CellView view =
              new CellView(
                  new PreviewWorkbench(session),
                  draft,
                  signal -> signal.equals("digital_out[1]") ? "Gripper" : "");
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
  void formsStayWhereTheyAreWhenTheSceneWaitsToBeApplied() throws Exception {
    show(
        view -> {
          Component forms = find(view, "cell-object-list", JList.class);
          Point before = SwingUtilities.convertPoint(forms, 0, 0, view.component());
          JTextArea waiting = find(view, "cell-waiting", JTextArea.class);
          waiting.setVisible(true);
          waiting.setText("The 3D view shows your changes.");
          view.component().validate();
          assertEquals(before, SwingUtilities.convertPoint(forms, 0, 0, view.component()));
        });
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
          assertEquals("radius is 0 mm, must be 1 to 10000 mm", ((EntryField) radius).refusal());
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

  private static String problem(CellView view, String name) {
    return find(view, name, JTextArea.class).getText();
  }

  @SuppressWarnings("unchecked") // the boxes for signals hold texts
  private static JComboBox<String> signals(CellView view, String name) {
    return find(view, name, JComboBox.class);
  }

  /** An entry of the menu that adds devices. */
  private static void add(CellView view, String kind) {
    fromMenu(view, "cell-device-add", kind);
  }

  private static void fromMenu(CellView view, String menu, String kind) {
    AbstractButton button = find(view, menu, AbstractButton.class);
    button.doClick(0);
    for (MenuElement each : MenuSelectionManager.defaultManager().getSelectedPath()) {
      for (MenuElement entry : each.getSubElements()) {
        if ((menu + "-" + kind).equals(entry.getComponent().getName())) {
          ((AbstractButton) entry).doClick(0);
          MenuSelectionManager.defaultManager().clearSelectedPath();
          return;
        }
      }
    }
    throw new AssertionError("there is no entry for " + kind);
  }

  @Test
  void aDeviceIsAddedAndSetUpInItsForm() throws Exception {
    show(
        view -> {
          add(view, "gripper-driven-by-outputs");
          assertEquals(
              "[\n    {\"type\": \"gripper\", \"close\": \"digital_out[0]\"}\n  ]",
              draft.equipment().get("devices"));
          type(view, "cell-device-name", "left");
          type(view, "cell-device-gripper-stroke", "60");
          signals(view, "cell-device-gripper-close").setSelectedItem("digital_out[1]");
          DeviceSetup.Driven gripper = (DeviceSetup.Driven) draft.devices().getFirst().getFirst();
          assertEquals("left", gripper.name());
          assertEquals(0.06, gripper.strokeM());
          assertEquals("digital_out[1]", gripper.close().toString());
          type(view, "cell-device-gripper-stroke", "");
          assertEquals(0.05, draft.devices().getFirst().getFirst().strokeM());
          press(view, "cell-device-remove");
          assertTrue(draft.equipment().isEmpty());
        });
  }

  @Test
  void signalsAreListedWithTheirNames() throws Exception {
    show(
        view -> {
          add(view, "door");
          JComboBox<String> closed = signals(view, "cell-device-door-closed");
          assertEquals("", closed.getItemAt(0));
          assertEquals("digital_in[0]", closed.getItemAt(1));
          JComboBox<String> close = signals(view, "cell-device-door-close");
          JLabel cell =
              (JLabel)
                  close
                      .getRenderer()
                      .getListCellRendererComponent(
                          new JList<>(), "digital_out[1]", 1, false, false);
          assertEquals("digital_out[1]  Gripper", cell.getText());
        });
  }

  @Test
  void aDoorMovesAnObjectInOneWayOrAnother() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-box");
          type(view, "cell-object-mass", "4");
          add(view, "door");
          JComboBox<?> moves = find(view, "cell-device-door-moves", JComboBox.class);
          moves.setSelectedIndex(1);
          assertTrue(find(view, "cell-device-door-slides-slides-x", JTextField.class).isVisible());
          type(view, "cell-device-door-slides-slides-x", "200");
          type(view, "cell-device-door-slides-slides-z", "0");
          type(view, "cell-device-door-slides-force", "80");
          DeviceSetup.Door door = (DeviceSetup.Door) draft.devices().getFirst().getFirst();
          assertEquals(
              new DoorLeaf.Slide("Box_1", new BodyRail.Line(1, 0, 0, 0.2, 80, 0)),
              door.leaf().orElseThrow());
          moves.setSelectedIndex(2);
          assertFalse(find(view, "cell-device-door-slides-slides-x", JTextField.class).isVisible());
          type(view, "cell-device-door-turns-turns-z", "60");
          door = (DeviceSetup.Door) draft.devices().getFirst().getFirst();
          DoorLeaf.Turn turn = (DoorLeaf.Turn) door.leaf().orElseThrow();
          assertEquals(Math.toRadians(60), turn.axis().angleRad(), 1e-9);
          assertEquals(50, turn.axis().frictionNm());
          moves.setSelectedIndex(0);
          door = (DeviceSetup.Door) draft.devices().getFirst().getFirst();
          assertTrue(door.leaf().isEmpty());
        });
  }

  private static List<String> headings(CellView view) {
    return headings(view, "cell-object-heading");
  }

  private static List<String> headings(CellView view, String name) {
    return all(view.component()).stream()
        .filter(each -> name.equals(each.getName()) && each.isShowing())
        .map(each -> ((JTextArea) each).getText())
        .toList();
  }

  @Test
  void placesAreInTheBaseOfTheOnlyArmAndInTheCellOfSeveral() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-box");
          assertTrue(headings(view).contains("Centre and orientation, in the base"));
        });
    draft.open(
        SceneFile.of(
            "two.scene.json", "{\"arms\": [{\"name\": \"left\"}, {\"name\": \"right\"}]}"));
    show(
        view -> {
          press(view, "cell-object-add-box");
          assertTrue(headings(view).contains("Centre and orientation, in the cell"));
          press(view, "cell-object-add-plane");
          assertTrue(headings(view).contains("A point of it, in the cell"));
          press(view, "cell-object-add-compound");
          assertTrue(headings(view).contains("Frame and orientation, in the cell"));
          add(view, "proximity-sensor");
          assertEquals(
              List.of("At: where it is, in the cell"), headings(view, "cell-device-heading"));
        });
  }

  @Test
  void aNoteIsThereAgainWithTheRowsThatItIsAbout() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-box");
          press(view, "cell-object-add-plane");
          find(view, "cell-object-list", JList.class).setSelectedIndex(0);
          assertTrue(
              all(view.component()).stream()
                  .anyMatch(each -> "cell-object-note".equals(each.getName()) && each.isShowing()));
        });
  }

  private SceneObject.Compound compound() {
    return (SceneObject.Compound) draft.scene().objects().getFirst();
  }

  @Test
  void aCompoundIsPutTogetherPartByPart() throws Exception {
    show(
        view -> {
          press(view, "cell-object-add-compound");
          type(view, "cell-object-mass", "2");
          assertEquals(2, compound().massKg());
          fromMenu(view, "cell-object-part-add", "cylinder");
          assertEquals(3, compound().parts().size());
          type(view, "cell-object-part-pose-z", "70");
          type(view, "cell-object-part-part-name", "pin");
          assertEquals(
              new SceneObject.Rod(
                  "pin", new Pose(0, 0, 0.07, 0, 0, 0), 0.01, 0.04, false, Material.DEFAULT, 0),
              compound().parts().getLast());
          find(view, "cell-object-parts", JComboBox.class).setSelectedIndex(1);
          type(view, "cell-object-part-length-z", "120");
          assertEquals(
              new Vector3(0.01, 0.05, 0.12), ((SceneObject.Box) compound().parts().get(1)).sizeM());
          press(view, "cell-object-part-parts-weigh-differently");
          assertFalse(find(view, "cell-object-mass", JTextField.class).isVisible());
          type(view, "cell-object-part-part-mass", "0.7");
          assertEquals(0.7, compound().parts().get(1).massKg());
          press(view, "cell-object-part-remove");
          assertEquals(
              List.of("foot", "pin"), compound().parts().stream().map(SceneObject::name).toList());
          press(view, "cell-undo");
          press(view, "cell-undo");
          press(view, "cell-undo");
          assertEquals(2, compound().massKg());
          assertTrue(find(view, "cell-object-mass", JTextField.class).isVisible());
        });
  }

  @Test
  void whatADeviceCannotHaveIsRefusedAtItsFieldAndStaysThere() throws Exception {
    show(
        view -> {
          add(view, "door");
          JTextField time = find(view, "cell-device-door-time", JTextField.class);
          time.setText("70");
          assertEquals(
              "is 70 s, must be 0.01 to 60 s", problem(view, "cell-device-door-time-problem"));
          time.postActionEvent();
          add(view, "two-finger-gripper");
          press(view, "cell-device-up");
          find(view, "cell-device-list", JList.class).setSelectedIndex(1);
          assertEquals("70", time.getText());
          assertEquals(
              "is 70 s, must be 0.01 to 60 s", problem(view, "cell-device-door-time-problem"));
          type(view, "cell-device-door-time", "4");
          assertEquals(4, ((DeviceSetup.Door) draft.devices().getFirst().get(1)).timeS());
          JTextField name = find(view, "cell-device-name", JTextField.class);
          name.setText("two-finger");
          assertEquals(
              "name is \"two-finger\" as in line 3, must be another for each device",
              problem(view, "cell-device-name-problem"));
        });
  }

  @Test
  void fingertipsAreAtTheTcpUnlessAPlaceIsTyped() throws Exception {
    show(
        view -> {
          add(view, "two-finger-gripper");
          type(view, "cell-device-two-finger-fingers-width", "30");
          press(view, "cell-device-two-finger-fingers-at-the-active-tcp");
          type(view, "cell-device-two-finger-fingers-at-z", "170");
          GripperSetup gripper = draft.devices().getFirst().getFirst().gripper().orElseThrow();
          assertEquals(new Pose(0, 0, 0.17, 0, 0, 0), gripper.atInFlange().orElseThrow());
          assertEquals(new GripperSetup.Grip.Pads(0.03, 0.022), gripper.grip());
          press(view, "cell-device-two-finger-fingers-at-the-active-tcp");
          type(view, "cell-device-two-finger-fingers-width", "");
          assertEquals("[\n    {\"type\": \"two-finger\"}\n  ]", draft.equipment().get("devices"));
        });
  }

  @Test
  void rulesAreWrittenAsTextAndRefusedWithTheirPlace() throws Exception {
    show(
        view -> {
          JTextArea area = find(view, "cell-rules", JTextArea.class);
          assertEquals("", area.getText());
          area.setText("[\n  {\"every\": 0, \"set\": \"digital_in[0]\"}\n]");
          String refusal = problem(view, "cell-rules-problem");
          assertTrue(
              refusal.startsWith("line 2, column 13: every is 0 s, must be 0.01 to 3600 s"),
              refusal);
          add(view, "door");
          assertEquals("[\n  {\"every\": 0, \"set\": \"digital_in[0]\"}\n]", area.getText());
          area.setText("[{\"every\": 5, \"set\": \"digital_in[0]\"}]");
          area.getActionMap().get("control ENTER").actionPerformed(null);
          assertEquals(
              "[{\"every\": 5, \"set\": \"digital_in[0]\"}]", draft.equipment().get("rules"));
          press(view, "cell-undo");
          assertFalse(draft.equipment().containsKey("rules"));
          assertEquals("", area.getText());
        });
  }

  @Test
  void devicesFollowTheNameOfAnObject() throws Exception {
    show(
        view -> {
          add(view, "belt");
          assertEquals(
              "object is \"none\", must be the name of a box that stands still",
              problem(view, "cell-device-problem"));
          press(view, "cell-object-add-box");
          add(view, "belt");
          assertEquals(1, draft.devices().size());
          type(view, "cell-object-name", "conveyor");
          assertEquals(
              "conveyor", ((DeviceSetup.Belt) draft.devices().getFirst().getFirst()).object());
          press(view, "cell-object-remove");
          assertEquals(
              "object is \"conveyor\", must be the name of a box that stands still",
              problem(view, "cell-object-problem"));
        });
  }

  @Test
  void rulesFollowTheNameOfAGripper() throws Exception {
    show(
        view -> {
          add(view, "two-finger-gripper");
          JTextArea area = find(view, "cell-rules", JTextArea.class);
          area.setText("[{\"every\": 5, \"part\": \"two-finger\", \"width\": 0.03}]");
          area.getActionMap().get("control ENTER").actionPerformed(null);
          type(view, "cell-device-name", "left");
          assertEquals("[{\"every\": 5, \"part\": \"left\", \"width\": 0.03}]", area.getText());
          press(view, "cell-device-remove");
          assertEquals(1, draft.devices().size());
          assertTrue(problem(view, "cell-device-problem").startsWith("part is \"left\""));
        });
  }

  private static void key(WireList list, String keys) {
    list.getActionMap()
        .get(list.getInputMap().get(KeyStroke.getKeyStroke(keys)))
        .actionPerformed(null);
  }

  @Test
  void aPortIsWiredByKeys() throws Exception {
    show(
        view -> {
          add(view, "gripper-driven-by-outputs");
          find(view, "cell-pages", JTabbedPane.class).setSelectedIndex(1);
          WireList ports = find(view, "cell-wiring-ports", WireList.class);
          WireList signals = find(view, "cell-wiring-signals", WireList.class);
          ports.select(row -> row.text().equals("Gripped"));
          key(ports, "ENTER");
          signals.select(row -> row.text().equals("digital_out[3]"));
          key(signals, "ENTER");
          assertEquals(
              "Not possible: Gripped of gripper is set by the device: it goes to an input,"
                  + " digital_out[3] is an output",
              problem(view, "cell-wiring-said"));
          signals.select(row -> row.text().equals("tool_in[1]"));
          key(signals, "ENTER");
          assertEquals("tool_in[1]", device().text("gripped"));
          key(ports, "DELETE");
          assertEquals("", device().text("gripped"));
          press(view, "cell-undo");
          assertEquals("tool_in[1]", device().text("gripped"));
        });
  }

  @Test
  void aWireIsDrawnByMouse() throws Exception {
    show(
        view -> {
          add(view, "door");
          find(view, "cell-pages", JTabbedPane.class).setSelectedIndex(1);
          view.component().validate();
          WireList ports = find(view, "cell-wiring-ports", WireList.class);
          WireList signals = find(view, "cell-wiring-signals", WireList.class);
          drag(ports, "Closed", signals, "digital_out[2]");
          assertEquals("", device().text("closed"), "an output is set by programs");
          drag(ports, "Closed", signals, "digital_in[2]");
          assertEquals("digital_in[2]", device().text("closed"));
          drag(signals, "digital_out[5]", ports, "Close");
          assertEquals("digital_out[5]", device().text("close"));
        });
  }

  @Test
  void aDeviceIsPutAtTheTcpOfTheArmThatIsShownWhereverThatStandsInTheCell() throws Exception {
    session.restart(SharedCell.setup());
    session.show("right");
    draft.open(SceneFile.of("two.scene.json", SharedCell.SCENE));
    show(
        view -> {
          Pose tcp = session.state().arm().targetTcpInBase();
          add(view, "proximity-sensor");
          press(view, "cell-device-proximity-here");
          assertEquals(1 - tcp.x(), device().place("at").x(), 1e-5);
          assertEquals(-tcp.y(), device().place("at").y(), 1e-5);
        });
  }

  @Test
  void aDeviceIsPutAtTheTcp() throws Exception {
    show(
        view -> {
          Pose tcp = session.state().arm().targetTcpInBase();
          add(view, "proximity-sensor");
          press(view, "cell-device-proximity-here");
          assertEquals(tcp.x(), device().place("at").x(), 1e-5);
          assertEquals(tcp.z(), device().place("at").z(), 1e-5);
          press(view, "cell-device-remove");
          add(view, "light-barrier");
          press(view, "cell-device-light-barrier-to-here");
          assertEquals(tcp.y(), device().place("to").y(), 1e-5);
          assertEquals(0.4, device().place("from").x());
        });
  }

  @Test
  void wiresNeedNoRoom() throws Exception {
    show(
        view -> {
          add(view, "door");
          find(view, "cell-pages", JTabbedPane.class).setSelectedIndex(1);
          JComponent board = find(view, "cell-wiring-board", JComponent.class);
          for (int height : List.of(0, 1, 300)) {
            board.setSize(400, height);
            board.doLayout();
            assertEquals(height, board.getComponent(0).getHeight());
          }
        });
  }

  private DeviceText device() {
    return Equipment.devices(draft.equipment()).getFirst();
  }

  private static void drag(WireList from, String row, WireList to, String target) {
    Point begin = from.pin(each -> each.text().equals(row)).orElseThrow();
    Point end =
        SwingUtilities.convertPoint(
            to, to.pin(each -> each.text().equals(target)).orElseThrow(), from);
    int inwards = to.getX() + 20;
    boolean toLeft = end.x < begin.x;
    mouse(from, MouseEvent.MOUSE_PRESSED, new Point(begin.x + (toLeft ? 5 : -5), begin.y));
    Point at = new Point(end.x + (toLeft ? -inwards : inwards), end.y);
    mouse(from, MouseEvent.MOUSE_DRAGGED, at);
    mouse(from, MouseEvent.MOUSE_RELEASED, at);
  }

  private static void mouse(WireList list, int id, Point at) {
    list.dispatchEvent(
        new MouseEvent(
            list, id, 0, InputEvent.BUTTON1_DOWN_MASK, at.x, at.y, 1, false, MouseEvent.BUTTON1));
  }
}
