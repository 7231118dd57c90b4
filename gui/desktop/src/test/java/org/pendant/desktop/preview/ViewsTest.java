package org.pendant.desktop.preview;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.TestController;
import org.pendant.controller.box.BoxCommand;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.io.IoView;
import org.pendant.desktop.io.SignalLabels;
import org.pendant.desktop.log.LogView;
import org.pendant.desktop.plot.PlotView;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.theme.Contrast;
import org.pendant.kit.theme.Look;
import org.pendant.kit.theme.Theme;
import org.pendant.script.vm.Program;

/** The screens in a real window, as far as there is a display. */
@Tag("slow")
final class ViewsTest {
  private static final String PROGRAM =
      "def talk():\n  textmsg(\"one\")\n  textmsg(\"two\")\n  sync()\n  x = [1][2]\nend\n";

  /** What a busy computer may add to the log. */
  private static final String LATE = "behind the wall clock";

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

  /** Work on the dispatch thread with a view in a window. */
  private interface Work {
    void on(View view);
  }

  private void show(Function<Workbench, View> kind, Work work)
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          Look look = new Look(workbench.settings());
          look.install();
          look.setTheme(Theme.LIGHT);
          View view = kind.apply(workbench);
          JFrame frame = new JFrame(view.title());
          frame.add(view.component());
          frame.setSize(1024, 700);
          frame.setVisible(true);
          try {
            view.refresh(session.state());
            work.on(view);
            look.setTheme(Theme.DARK);
            view.refresh(session.state());
            paint(view.component());
            assertEquals(List.of(), Contrast.hardToRead(view.component()));
          } finally {
            frame.dispose();
          }
        });
  }

  private static void paint(JComponent component) {
    BufferedImage image = new BufferedImage(1024, 700, BufferedImage.TYPE_INT_RGB);
    component.paint(image.createGraphics());
  }

  private static <C extends Component> C find(Container in, String name, Class<C> kind) {
    for (Component each : in.getComponents()) {
      if (name.equals(each.getName())) {
        return kind.cast(each);
      }
      if (each instanceof Container inner) {
        C found = find(inner, name, kind);
        if (found != null) {
          return found;
        }
      }
    }
    return null;
  }

  private static Stream<String> rows(JTable table) {
    return IntStream.range(0, table.getRowCount())
        .mapToObj(
            row ->
                IntStream.range(0, table.getColumnCount())
                    .mapToObj(column -> String.valueOf(table.getValueAt(row, column)))
                    .collect(Collectors.joining(" ")));
  }

  private void runToItsEnd() {
    Program program = TestController.program(session.robot(), PROGRAM);
    session.run(program).join();
    while (session.state().program().ending().isEmpty()) {
      // a command is answered at the end of a frame
      session.submit(new BoxCommand.SetSpeedFraction(1)).join();
    }
    // listeners hear of a frame after its replies, and before those of the next one
    session.submit(new BoxCommand.SetSpeedFraction(1)).join();
  }

  @Test
  void theLogKeepsHalfOfALowWindowForItsMessages()
      throws InterruptedException, InvocationTargetException {
    show(
        LogView::new,
        view -> {
          Window window = SwingUtilities.getWindowAncestor(view.component());
          window.setSize(616, 300);
          window.validate();
          JSplitPane split = find(view.component(), "log-split", JSplitPane.class);
          int messages = split.getTopComponent().getHeight();
          assertTrue(messages > split.getBottomComponent().getHeight(), () -> messages + " pixels");
        });
  }

  @Test
  void theLogShowsWhatProgramsSayAndWhyTheyEnd()
      throws InterruptedException, InvocationTargetException {
    show(
        LogView::new,
        view -> {
          runToItsEnd();
          view.refresh(session.state());
          JTable table = find(view.component(), "log-table", JTable.class);
          // three of the program, and that it started and ended
          assertEquals(5, rows(table).filter(row -> !row.contains(LATE)).count());
          find(view.component(), "log-search", JTextField.class).setText("stopped");
          find(view.component(), "log-show-source", AbstractButton.class).doClick(0);
          assertEquals(List.of("source 5:1"), workbench.told());
        });
  }

  @Test
  void anInputIsForcedByItsSwitch() throws InterruptedException, InvocationTargetException {
    show(
        IoView::new,
        view -> {
          find(view.component(), "digital-in-3", AbstractButton.class).doClick(0);
          session.submit(new BoxCommand.SetSpeedFraction(1)).join();
          assertEquals(8, session.state().io().standardIn());
        });
  }

  @Test
  void chartsComeAndGo() throws InterruptedException, InvocationTargetException {
    show(
        made ->
            new PlotView(made, new SignalLabels(made.settings()), new HiddenNames(made.settings())),
        view -> {
          AbstractButton remove =
              find(view.component(), "plot-remove-tcp_speed", AbstractButton.class);
          remove.doClick(0);
          assertEquals(
              "actual_q_0,actual_q_1,actual_q_2,actual_q_3,actual_q_4,actual_q_5",
              workbench.settings().get("plot.charts").orElseThrow());
          assertTrue(view.component().isShowing());
        });
  }
}
