package org.pendant.desktop.waveform;

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
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.TestController;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SharedCell;

/** In a cell of several controllers each has waveforms of its own. */
@Timeout(60)
final class WaveformCellTest {
  private static final String HIGH_AT_A_TENTH = "time,signal,value;0.1,digital_in[3],true;";

  private RobotSession session;
  private PreviewWorkbench workbench;
  private WaveformView view;

  @BeforeEach
  void open() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    session = RobotSession.start(ControllerOptions.headless());
    session.restart(SharedCell.setup());
    workbench = new PreviewWorkbench(session);
    workbench.settings().put("waveforms.table.left", HIGH_AT_A_TENTH);
    workbench.settings().put("waveforms.play.left", "true");
    EventQueue.invokeAndWait(
        () -> {
          FlatLaf.setup(new FlatLightLaf());
          view = new WaveformView(workbench, _ -> "", () -> {});
        });
  }

  @AfterEach
  void close() {
    if (session != null) {
      session.close();
    }
  }

  private void show(String controller) throws Exception {
    session.show(controller);
    EventQueue.invokeAndWait(() -> {});
  }

  private <C extends Component> C find(String name, Class<C> kind) {
    return kind.cast(find(view.component(), name));
  }

  private static Component find(Container in, String name) {
    for (Component each : in.getComponents()) {
      if (name.equals(each.getName())) {
        return each;
      }
      if (each instanceof Container inner && find(inner, name) instanceof Component found) {
        return found;
      }
    }
    return null;
  }

  private boolean empty() {
    return find("waveform-note", Component.class).isVisible();
  }

  private void add(String signal) throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          find("waveform-signal-text", JTextField.class).setText(signal);
          find("waveform-add", AbstractButton.class).doClick();
        });
  }

  private boolean playing() {
    return find("waveform-play", AbstractButton.class).isSelected();
  }

  @Test
  void thePanelHasTheWaveformsOfTheControllerThatIsShown() throws Exception {
    assertFalse(empty());
    assertTrue(playing());
    show("right");
    assertTrue(empty());
    assertFalse(playing());
    add("digital_in[5]");
    assertFalse(empty());
    show("cell");
    assertTrue(empty());
    show("left");
    assertTrue(playing());
    assertFalse(empty());
    assertEquals(HIGH_AT_A_TENTH, workbench.settings().get("waveforms.table.left").orElseThrow());
    show("right");
    assertFalse(empty());
  }

  @Test
  void eachControllerPlaysItsOwnWhicheverIsShown() throws Exception {
    show("right");
    session.setPace(new Pace.Unlimited());
    Map<String, Boolean> high = new ConcurrentHashMap<>();
    CompletableFuture<Boolean> over = new CompletableFuture<>();
    session.addCellListener(
        (member, state) -> {
          high.merge(member.name(), (state.io().standardIn() & 8) != 0, Boolean::logicalOr);
          if (member.name().equals("right") && (state.io().standardOut() & 1) != 0) {
            over.complete(true);
          }
        });
    String waits = "sleep(0.5)\nset_standard_digital_out(0, True)\n";
    for (SessionMember each : session.members()) {
      var _ = session.run(each, TestController.program(each.robot(), waits));
    }
    assertTrue(over.get(30, TimeUnit.SECONDS));
    assertEquals(Map.of("left", true, "right", false, "cell", false), high);
  }
}
