package org.pendant.desktop.installation;

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
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.kit.form.EntryField;

@Tag("slow")
final class InstallationViewTest {
  private final ActiveInstallation active = new ActiveInstallation();
  private RobotSession session;
  private PreviewWorkbench workbench;

  @BeforeEach
  void start() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    session = RobotSession.start(ControllerOptions.headless());
    workbench = new PreviewWorkbench(session);
  }

  @AfterEach
  void close() {
    if (session != null) {
      session.close();
    }
  }

  /** Work on the dispatch thread with the view in a window. */
  private interface Work {
    void on(InstallationView view);
  }

  private void show(Work work) throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          FlatLaf.setup(new FlatLightLaf());
          InstallationView view = new InstallationView(workbench, active);
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

  private static <C extends JComponent> C find(InstallationView view, String name, Class<C> kind) {
    // questions float over the view
    return all(SwingUtilities.getRootPane(view.component()).getLayeredPane()).stream()
        .filter(each -> name.equals(each.getName()))
        .findFirst()
        .map(kind::cast)
        .orElseThrow(() -> new AssertionError("there is no " + name));
  }

  private static void press(InstallationView view, String name) {
    find(view, name, AbstractButton.class).doClick(0);
  }

  private static void choose(InstallationView view, String page) {
    JList<?> pages = find(view, "installation-pages", JList.class);
    for (int i = 0; i < pages.getModel().getSize(); i++) {
      if (pages.getModel().getElementAt(i) instanceof PageName each && each.id().equals(page)) {
        pages.setSelectedIndex(i);
      }
    }
  }

  private static void type(InstallationView view, String name, String text) {
    JTextField field = find(view, name, JTextField.class);
    field.setText(text);
    field.postActionEvent();
  }

  @Test
  void lengthsAndAnglesAreInTheUnitsThatPeopleHaveChosen() throws Exception {
    active.set(Installation.NONE.with(parts -> parts.homeRad = parts.homeRad.with(0, 1)));
    show(
        view -> {
          choose(view, "home");
          assertEquals("57.296", find(view, "home-base", JTextField.class).getText());
          FormMemory.write(
              workbench.settings(),
              new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, RotationForm.VECTOR));
          view.refresh(session.state());
          assertEquals("1", find(view, "home-base", JTextField.class).getText());
          choose(view, "limits");
          assertEquals(
              "59.0551", find(view, "limits-normal-tool-speed", JTextField.class).getText());
        });
  }

  @Test
  void aTcpIsAddedTypedAndMadeActive() throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          choose(view, "tcp");
          press(view, "tcp-add-tcp");
          type(view, "tcp-name", "Gripper");
          type(view, "tcp-tcp-z", "120");
          press(view, "tcp-set");
          Installation now = active.current();
          assertEquals("Gripper", now.activeTool());
          assertEquals(0.12, now.activeToolInFlange().z(), 1e-12);
        });
  }

  @Test
  void whatCannotBeIsRefusedAtTheFieldAndChangesNothing()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          choose(view, "payload");
          press(view, "payload-add-payload");
          Installation before = active.current();
          type(view, "payload-mass", "heavy");
          assertEquals("'heavy' is not a number in kg", refusal(view, "payload-mass"));
          type(view, "payload-mass", "500");
          assertTrue(refusal(view, "payload-mass").startsWith("the mass is 500.0 kg"));
          assertEquals(before, active.current());
          type(view, "payload-mass", "1,5");
          assertEquals(1.5, active.current().payloads().getFirst().massKg());
        });
  }

  private static String refusal(InstallationView view, String name) {
    return find(view, name, EntryField.class).refusal();
  }

  @Test
  void aFeatureIsTaughtPointByPoint() throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          choose(view, "features");
          press(view, "feature-add-line");
          assertFalse(find(view, "feature-teach-1", AbstractButton.class).isEnabled());
          press(view, "feature-teach-0");
          press(view, "feature-teach-1");
          assertEquals(2, active.current().features().getFirst().points().size());
          assertEquals(
              session.state().arm().targetTcpInBase(),
              active.current().features().getFirst().points().getFirst());
        });
  }

  @Test
  void safetyIsLockedUntilUnlockedAndHoldsWhenApplied()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          choose(view, "planes");
          press(view, "planes-unlock");
          press(view, "plane-add-plane");
          assertEquals(Installation.NONE, active.current());
          press(view, "planes-apply");
          press(view, "planes-apply-really");
          assertEquals(1, active.current().safety().orElseThrow().planes().size());
        });
  }

  private static void applyOnePlane(InstallationView view) {
    choose(view, "planes");
    press(view, "planes-unlock");
    press(view, "plane-add-plane");
    press(view, "planes-apply");
    press(view, "planes-apply-really");
  }

  private static boolean asks(InstallationView view) {
    return all(SwingUtilities.getRootPane(view.component()).getLayeredPane()).stream()
        .anyMatch(each -> "installation-safety-really".equals(each.getName()));
  }

  @Test
  void undoOfWhatSafetyKnowsAsksAsApplyingItDoes() throws Exception {
    show(
        view -> {
          applyOnePlane(view);
          Installation applied = active.current();
          press(view, "installation-undo");
          assertEquals("Plane Plane_1: removed", changes(view));
          assertEquals("Undo and power off", words(view));
          assertEquals(applied, active.current());
          press(view, "installation-safety-back");
          assertFalse(asks(view));
          assertEquals(applied, active.current());
          press(view, "installation-undo");
          press(view, "installation-safety-really");
          assertEquals(Installation.NONE, active.current());
          assertFalse(asks(view));
          press(view, "installation-redo");
          assertEquals("Redo and power off", words(view));
          press(view, "installation-safety-really");
          assertEquals(applied, active.current());
        });
  }

  @Test
  void tabStaysInTheQuestionThatFloatsOverThePage() throws Exception {
    show(
        view -> {
          choose(view, "planes");
          press(view, "planes-unlock");
          press(view, "plane-add-plane");
          press(view, "planes-apply");
          Component back = find(view, "planes-apply-back", AbstractButton.class);
          Container asked = back.getFocusCycleRootAncestor();
          assertEquals(
              find(view, "planes-apply-really", AbstractButton.class),
              asked.getFocusTraversalPolicy().getComponentAfter(asked, back));
        });
  }

  private static String changes(InstallationView view) {
    return find(view, "installation-safety-changes", JTextArea.class).getText();
  }

  private static String words(InstallationView view) {
    return find(view, "installation-safety-really", AbstractButton.class).getText();
  }

  @Test
  void undoOfAnythingElseDoesNotAsk() throws Exception {
    show(
        view -> {
          active.set(Installation.NONE.with(parts -> parts.homeRad = parts.homeRad.with(0, 1)));
          press(view, "installation-undo");
          assertFalse(asks(view));
          assertEquals(Installation.NONE, active.current());
        });
  }

  @Test
  void nothingOfAPageMovesWhenItAsksWhetherToApply() throws Exception {
    show(
        view -> {
          choose(view, "planes");
          press(view, "planes-unlock");
          press(view, "plane-add-plane");
          view.component().validate();
          JComponent add = find(view, "plane-add-plane", JComponent.class);
          Point before = add.getLocationOnScreen();
          press(view, "planes-apply");
          view.component().validate();
          assertEquals(before, add.getLocationOnScreen());
        });
  }

  @Test
  void afterApplyingTheKeysAreInTheBar() throws Exception {
    show(
        view -> {
          applyOnePlane(view);
          assertEquals("planes-unlock", keysGoTo(view));
        });
  }

  @Test
  void keysStayInTheBarWhenSafetyIsUnlockedAndLocked()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          choose(view, "planes");
          press(view, "planes-unlock");
          assertEquals("planes-discard", keysGoTo(view));
          press(view, "planes-discard");
          assertEquals("planes-unlock", keysGoTo(view));
        });
  }

  /** What gets the keys in the window of the view, or gets them when that comes to the front. */
  private static String keysGoTo(InstallationView view) {
    return SwingUtilities.getWindowAncestor(view.component()).getMostRecentFocusOwner().getName();
  }

  @Test
  void whatIsTypedOfAPlaneIsProposedUntilItIsTakenBack()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          choose(view, "planes");
          press(view, "planes-unlock");
          press(view, "plane-add-plane");
          JTextField height = find(view, "plane-z", JTextField.class);
          height.setText("150");
          assertEquals(0.15, proposedHeightM(view));
          height.setText("150x");
          assertEquals(0, proposedHeightM(view));
          height.setText("200");
          height.getActionMap().get("as-it-was").actionPerformed(null);
          assertEquals(0, proposedHeightM(view));
          type(view, "plane-z", "250");
          assertEquals(0.25, proposedHeightM(view));
          press(view, "planes-discard");
          assertEquals(Optional.empty(), view.proposedSafety());
        });
  }

  private static double proposedHeightM(InstallationView view) {
    return view.proposedSafety().orElseThrow().planes().getFirst().pointZM();
  }

  @Test
  void everyControlHasANameForScreenReaders()
      throws InterruptedException, InvocationTargetException {
    show(
        view -> {
          List<String> nameless =
              all(view.component()).stream()
                  .filter(
                      each ->
                          each.getName() != null
                              && (each instanceof AbstractButton
                                  || each instanceof JTextField
                                  || each instanceof JComboBox))
                  .filter(
                      each -> {
                        String words = each.getAccessibleContext().getAccessibleName();
                        return words == null || words.isBlank();
                      })
                  .map(Component::getName)
                  .toList();
          assertEquals(List.of(), nameless);
        });
  }

  @Test
  void externalControlGetsItsScriptWhereSomebodyTypes() throws Exception {
    show(
        view -> {
          choose(view, "external-control");
          type(view, "external-control-host", " 10.0.0.7 ");
          type(view, "external-control-port", "50012");
          assertEquals(new ControlHost("10.0.0.7", 50012), active.current().controlHost());
          type(view, "external-control-port", "0");
          type(view, "external-control-port", "many");
          type(view, "external-control-host", "my pc");
          assertEquals(new ControlHost("10.0.0.7", 50012), active.current().controlHost());
        });
  }
}
