package org.pendant.desktop.preview;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Function;
import javax.swing.JFrame;
import javax.swing.Timer;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.io.IoView;
import org.pendant.desktop.io.SignalLabels;
import org.pendant.desktop.log.LogView;
import org.pendant.desktop.plot.PlotView;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.theme.PreviewLook;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;

/** Shows one view: {@code Preview log|io|plot light|dark WIDTH HEIGHT [FILE.script]}. */
public final class Preview {
  private static final int REFRESH_MS = 33;

  private Preview() {}

  /** Opens the window; the process ends with it. */
  public static void main(String[] args) throws IOException {
    RobotSession session = RobotSession.start(ControllerOptions.headless());
    if (args.length > 4) {
      start(session, Path.of(args[4]));
    }
    EventQueue.invokeLater(() -> open(args, session));
  }

  private static void start(RobotSession session, Path file) throws IOException {
    Source source = Source.of(file.toString(), Files.readAllBytes(file));
    LoadResult loadResult = session.robot().load(source);
    var _ = session.submit(new ProgramCommand.StartProgram(loadResult.program().orElseThrow()));
  }

  private static void open(String[] args, RobotSession session) {
    PreviewLook.install(args[1].equals("dark"));
    View view = viewNamed(args[0]).apply(new PreviewWorkbench(session));
    JFrame frame = new JFrame(view.title());
    frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
    frame.add(view.component());
    frame.setSize(Integer.parseInt(args[2]), Integer.parseInt(args[3]));
    frame.setVisible(true);
    new Timer(REFRESH_MS, event -> view.refresh(session.state())).start();
  }

  private static Function<Workbench, View> viewNamed(String name) {
    return switch (name) {
      case "log" -> LogView::new;
      case "io" -> IoView::new;
      case "plot" ->
          workbench ->
              new PlotView(
                  workbench,
                  new SignalLabels(workbench.settings()),
                  new HiddenNames(workbench.settings()));
      default ->
          throw new IllegalArgumentException("view is '" + name + "', must be log, io or plot");
    };
  }
}
