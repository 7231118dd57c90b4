package org.pendant.desktop.shell.chrome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Robot;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;

/** The list of robots in the header, by keys. */
final class RobotListTest {
  private final List<String> chosen = new ArrayList<>();
  private JFrame frame;
  private Header header;
  private JComboBox<?> robots;

  @BeforeEach
  void open() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    EventQueue.invokeAndWait(
        () -> {
          Programs programs = new Programs(ProgramDocument.untitled("a.script", ""));
          ActionTable actions = new ActionTable(new MemorySettings());
          header =
              new Header(new ProgramMenu(actions, programs, List::of, file -> {}), chosen::add);
          header.showRobot("ur5e");
          robots =
              Stream.of(header.getComponents())
                  .filter(each -> "robot".equals(each.getName()))
                  .map(each -> (JComboBox<?>) each)
                  .findFirst()
                  .orElseThrow();
          frame = new JFrame("robots");
          frame.add(header);
          frame.setSize(900, 80);
          frame.setVisible(true);
        });
    // a window that is still being placed closes lists
    new Robot().waitForIdle();
    EventQueue.invokeAndWait(
        () -> {
          robots.showPopup();
          press("selectNext");
          press("selectNext");
        });
  }

  @AfterEach
  void close() throws Exception {
    if (frame != null) {
      EventQueue.invokeAndWait(frame::dispose);
    }
  }

  private void press(String action) {
    robots
        .getActionMap()
        .get(action)
        .actionPerformed(new ActionEvent(robots, ActionEvent.ACTION_PERFORMED, action));
  }

  private String shown() throws Exception {
    // what the list tells when it closes comes before this
    EventQueue.invokeAndWait(() -> {});
    return robots.getSelectedItem().toString();
  }

  @Test
  void arrowKeysLookAtRobotsAndEnterChoosesOne() throws Exception {
    assertEquals("UR10e", shown());
    assertEquals(List.of(), chosen);
    EventQueue.invokeAndWait(() -> press("enterPressed"));
    shown();
    assertEquals(List.of("ur10e"), chosen);
  }

  @Test
  void escapeLeavesTheRobotThatThereIs() throws Exception {
    EventQueue.invokeAndWait(() -> press("hidePopup"));
    assertEquals("UR5e", shown());
    assertEquals(List.of(), chosen);
  }
}
