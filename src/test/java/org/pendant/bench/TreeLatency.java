package org.pendant.bench;

import static org.pendant.project.program.ProgramTree.node;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JFileChooser;
import javax.swing.JList;
import javax.swing.JScrollPane;
import org.pendant.desktop.shell.Desktop;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.FlowStep;
import org.pendant.project.program.MotionStep;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Setting;
import org.pendant.project.program.Timing;
import org.pendant.project.program.ToolChoice;
import org.pendant.project.program.WaitFor;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.WaypointTarget;
import org.pendant.project.program.text.ProgramText;

/**
 * How long the desktop takes to open a long program tree, from the press that chooses its file to
 * the end of its painting, and for each turn of the wheel over it. It needs a display, a virtual
 * one will do.
 */
final class TreeLatency {
  private static final int NODES = 2_000;
  private static final int OPENED = 6;
  private static final int TURNS = 600;
  private static final int WARM_UP_TURNS = 100;

  private final TimedQueue queue;
  private final int nodes;

  private TreeLatency(TimedQueue queue, int nodes) {
    this.queue = queue;
    this.nodes = nodes;
  }

  /**
   * Opens a desktop with settings of its own in another process, works there and prints a table.
   *
   * @param arguments none, or how many nodes; or {@code here} and that, in that other process
   */
  public static void main(String[] arguments) throws Exception {
    if (arguments.length == 2 && arguments[0].equals("here")) {
      measure(Integer.parseInt(arguments[1]));
      // The window would stay, and its process with it.
      Runtime.getRuntime().halt(0);
    }
    int nodes = arguments.length == 1 ? Integer.parseInt(arguments[0]) : NODES;
    ProcessBuilder child =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "--enable-native-access=ALL-UNNAMED",
                "--sun-misc-unsafe-memory-access=allow",
                "-cp",
                System.getProperty("java.class.path"),
                TreeLatency.class.getName(),
                "here",
                Integer.toString(nodes))
            .inheritIO();
    child
        .environment()
        .put("XDG_CONFIG_HOME", Files.createTempDirectory("pendant-tree").toString());
    int code = child.start().waitFor();
    if (code != 0) {
      throw new IOException("the window's process ended with " + code);
    }
  }

  private static void measure(int nodes) throws Exception {
    TimedQueue queue = new TimedQueue();
    Toolkit.getDefaultToolkit().getSystemEventQueue().push(queue);
    Desktop.open();
    press("rail-program");
    TreeLatency latency = new TreeLatency(queue, nodes);
    Path folder = Files.createTempDirectory("pendant-tree");
    List<Long> opened = new ArrayList<>();
    for (int i = 0; i < OPENED; i++) {
      Path file = folder.resolve("long" + i + ".pendant");
      Files.writeString(file, ProgramText.write(program(nodes, i)));
      opened.add(latency.open(file));
      // It is checked and its script is shown.
      TimeUnit.SECONDS.sleep(2);
    }
    JScrollPane scroll = (JScrollPane) await("program-tree-scroll");
    latency.scroll(scroll, WARM_UP_TURNS, new ArrayList<>(), new ArrayList<>());
    queue.longestNs.set(0);
    List<Long> wall = new ArrayList<>();
    List<Long> computing = new ArrayList<>();
    latency.scroll(scroll, TURNS, wall, computing);
    System.out.printf(Locale.ROOT, "%n### A program tree of %d nodes, ms%n%n", nodes);
    System.out.printf(
        Locale.ROOT,
        "Opened for the first time in %.0f, then in %s.%n%n",
        opened.getFirst() / 1e6,
        String.join(
            ", ", opened.stream().skip(1).map(ns -> String.valueOf(ns / 1_000_000)).toList()));
    System.out.println("| a turn of the wheel | p50 | p95 | p99 | longest |");
    System.out.println("| --- | ---: | ---: | ---: | ---: |");
    TypingLatency.row("until it is painted", wall);
    TypingLatency.row("computing of the dispatch thread", computing);
    System.out.printf(
        Locale.ROOT,
        "| longest event of any kind meanwhile | | | | %.2f |%n",
        queue.longestNs.get() / 1e6);
  }

  // --- opening

  /** From the press that chooses a file until its tree is painted, ns. */
  private long open(Path file) throws Exception {
    key(await("rail-program"), KeyEvent.VK_O, InputEvent.CTRL_DOWN_MASK);
    JFileChooser chooser = (JFileChooser) await("open-dialog");
    long startNs =
        dispatched(
            () -> {
              chooser.setSelectedFiles(new File[] {file.toFile()});
              long now = System.nanoTime();
              chooser.approveSelection();
              return now;
            });
    while (!dispatched(() -> showsAll(file))) {
      // Questions in between would delay what is measured.
      TimeUnit.MILLISECONDS.sleep(2);
    }
    queue.awaitPainted();
    return System.nanoTime() - startNs;
  }

  private boolean showsAll(Path file) {
    boolean named =
        find("program-name")
            .filter(each -> each instanceof AbstractButton)
            .filter(each -> ((AbstractButton) each).getText().contains(name(file)))
            .isPresent();
    return named
        && find("program-tree")
            .filter(each -> ((JList<?>) each).getModel().getSize() >= nodes)
            .isPresent();
  }

  private static String name(Path file) {
    return String.valueOf(file.getFileName());
  }

  private static void key(Component to, int code, int modifiers) throws Exception {
    dispatched(
        () -> {
          long now = System.currentTimeMillis();
          to.dispatchEvent(
              new KeyEvent(
                  to, KeyEvent.KEY_PRESSED, now, modifiers, code, KeyEvent.CHAR_UNDEFINED));
          return true;
        });
  }

  // --- scrolling

  /** Turns the wheel down and up again, as fast as a hand does. */
  private void scroll(JScrollPane scroll, int turns, List<Long> wall, List<Long> computing)
      throws Exception {
    for (int i = 0; i < turns; i++) {
      int way = i % 200 < 100 ? 1 : -1;
      queue.begin();
      queue.postEvent(
          new MouseWheelEvent(
              scroll,
              MouseEvent.MOUSE_WHEEL,
              System.currentTimeMillis(),
              0,
              scroll.getWidth() / 2,
              scroll.getHeight() / 2,
              0,
              false,
              MouseWheelEvent.WHEEL_UNIT_SCROLL,
              3,
              way));
      wall.add(queue.awaitPainted());
      computing.add(queue.endCpuNs.get() - queue.begunCpuNs.get());
      TimeUnit.MILLISECONDS.sleep(15);
    }
  }

  // --- the program

  /** A program of folders with ten nodes each, all of them complete. */
  private static ProgramTree program(int nodes, int variant) {
    ProgramTree tree = ProgramTree.empty();
    List<ProgramNode> parts = new ArrayList<>();
    for (int i = 0; i < nodes / 10; i++) {
      parts.add(part(i));
      for (int j = 0; j < 3; j++) {
        Joints joints = Joints.of(0.01 * i, -1.5 + 0.1 * j, 1.5, -1.57, -1.57, 0.001 * variant);
        tree =
            tree.withWaypoint(
                waypoint(i, j),
                new WaypointPosition(
                    new Pose(0.4, 0.001 * i, 0.3 + 0.05 * j, 0, 3.14, 0),
                    WaypointPosition.BASE,
                    joints,
                    Pose.ZERO));
      }
    }
    return tree.insert(tree.sections().getFirst().key(), 0, parts);
  }

  private static String waypoint(int part, int number) {
    return "Part_" + part + "_" + number;
  }

  private static ProgramNode part(int i) {
    return node(
        new ActionStep.Folder("Part " + i),
        node(
            new MotionStep.Move(
                MoveKind.JOINT, 1, 1.4, new ToolChoice.Active(), WaypointPosition.BASE, false),
            Stream.of(0, 1, 2)
                .map(
                    j ->
                        node(
                            new MotionStep.Waypoint(
                                new WaypointTarget.Fixed(waypoint(i, j)),
                                new Timing.AsMove(),
                                OptionalDouble.empty())))
                .toArray(ProgramNode[]::new)),
        node(new ActionStep.SetAction(new Setting.Digital("digital_out[" + i % 8 + "]", true))),
        node(new ActionStep.Wait(new WaitFor.Time(0.5))),
        node(
            new FlowStep.If("get_standard_digital_in(" + i % 8 + ")", false),
            node(new ActionStep.Comment("There is a part at place " + i))),
        node(new ActionStep.Comment("Part " + i + " is done")));
  }

  // --- the window

  private static void press(String name) throws Exception {
    AbstractButton button = (AbstractButton) await(name);
    dispatched(
        () -> {
          button.doClick(0);
          return true;
        });
  }

  private static Component await(String name) throws Exception {
    for (int tries = 0; tries < 300; tries++) {
      Optional<Component> found = dispatched(() -> find(name));
      if (found.isPresent()) {
        return found.get();
      }
      TimeUnit.MILLISECONDS.sleep(100);
    }
    throw new IOException("nothing visible is named " + name);
  }

  private static Optional<Component> find(String name) {
    return Stream.of(Window.getWindows())
        .filter(Window::isShowing)
        .flatMap(TreeLatency::all)
        .filter(each -> name.equals(each.getName()) && each.isShowing())
        .findFirst();
  }

  private static Stream<Component> all(Component component) {
    return component instanceof Container container
        ? Stream.concat(
            Stream.of(component), Stream.of(container.getComponents()).flatMap(TreeLatency::all))
        : Stream.of(component);
  }

  private static <T> T dispatched(Callable<T> work) throws Exception {
    FutureTask<T> task = new FutureTask<>(work);
    EventQueue.invokeAndWait(task);
    return task.get();
  }
}
