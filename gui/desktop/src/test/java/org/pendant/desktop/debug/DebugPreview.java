package org.pendant.desktop.debug;

import java.awt.EventQueue;
import java.awt.GridLayout;
import java.util.List;
import java.util.TreeSet;
import javax.swing.BorderFactory;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.theme.PreviewLook;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.Program;

/** Shows the panels of the debugger: {@code DebugPreview light|dark WIDTH HEIGHT held|idle}. */
public final class DebugPreview {
  private static final String PROGRAM =
      """
      def sorting():
        global place = p[0.1, -0.4, 0.3, 0, 3.14, 0]
        global parts = struct(name="bolt", sizes=[4, 5, 6], weightKg=0.25)
        global many = make_list(250, 0)
        global count = 0
        thread blinking():
          while True:
            sleep(0.5)
          end
        end
        handle = run blinking()
        def weigh(number):
          local doubled = number * 2
          count = count + doubled
          sleep(0.1)
        end
        while count < 100:
          weigh(3)
        end
      end
      """;

  private DebugPreview() {}

  /** Opens the window; the process ends with it. */
  public static void main(String[] args) {
    RobotSession session = RobotSession.start(ControllerOptions.headless());
    ProgramDocument document = ProgramDocument.untitled("sorting.script", PROGRAM);
    Program program = session.load(document.source()).program().orElseThrow();
    EventQueue.invokeLater(() -> open(args, session, document, program));
  }

  private static void open(
      String[] args, RobotSession session, ProgramDocument document, Program program) {
    PreviewLook.install(args[0].equals("dark"));
    PreviewWorkbench workbench = new PreviewWorkbench(session);
    DebugPresenter debug = new DebugPresenter(workbench, new Programs(document));
    BreakpointsView breakpoints = new BreakpointsView(workbench, debug);
    DebugActions.addTo(workbench, debug, breakpoints, () -> 15);
    List<View> views =
        List.of(
            new VariablesView(
                workbench,
                debug,
                new Favourites(workbench.settings()),
                new HiddenNames(workbench.settings()),
                expressions -> {}),
            new WatchesView(workbench, debug),
            new CallStackView(workbench, debug),
            breakpoints);
    JPanel grid = new JPanel(new GridLayout(2, 2, 8, 8));
    for (View view : views) {
      view.component().setBorder(BorderFactory.createTitledBorder(view.title()));
      grid.add(view.component());
    }
    JFrame frame = new JFrame("Debugger");
    frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
    frame.add(grid);
    frame.setSize(Integer.parseInt(args[1]), Integer.parseInt(args[2]));
    frame.setVisible(true);
    new Timer(33, event -> views.forEach(view -> view.refresh(session.state()))).start();
    if (args[3].equals("held")) {
      hold(session, debug, document, program);
    }
  }

  private static void hold(
      RobotSession session, DebugPresenter debug, ProgramDocument document, Program program) {
    debug.breakpoints().linesChanged(document, new TreeSet<>(List.of(15, 17)));
    debug.breakpoints().change(Breakpoint.at(15).when("count > 10").fromHit(2));
    debug.breakpoints().change(Breakpoint.at(17).disabled());
    List.of("count * 2", "parts.name", "missing + 1").forEach(debug::addWatch);
    debug.breakpoints().beforeRun(document);
    var _ = session.submit(new ProgramCommand.StartProgram(program));
    Timer later =
        new Timer(
            1500,
            event -> {
              ValueTree tree = debug.variables();
              tree.toggle(DebugFixture.row(tree, "parts"));
              tree.assign(DebugFixture.row(tree, "count"), "\"many\"");
              var _ = session.submit(new DebugCommand.Debug(Debugger::resume));
            });
    later.setRepeats(false);
    later.start();
    Timer edit =
        new Timer(
            2500,
            event -> {
              ValueTree tree = debug.variables();
              tree.assign(DebugFixture.row(tree, "place"), "[1]");
            });
    edit.setRepeats(false);
    edit.start();
  }
}
