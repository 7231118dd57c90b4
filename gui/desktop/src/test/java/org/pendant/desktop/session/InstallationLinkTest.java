package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.IoCommand;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.script.vm.Program;

@Timeout(60)
final class InstallationLinkTest {
  private static final String TOOL =
      "tool name=\"Gripper\" in-flange=[0, 0, 0.1, 0, 0, 0]\nactive-tool name=\"Gripper\"\n";

  /** Stands for the dispatch thread. */
  private final ExecutorService dispatch = Executors.newSingleThreadExecutor();

  private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
  private final BlockingQueue<Installation> changes = new LinkedBlockingQueue<>();
  private final BlockingQueue<Boolean> starts = new LinkedBlockingQueue<>();
  private final ActiveInstallation active = new ActiveInstallation();
  private RobotSession session;

  private static Installation installation(String lines) {
    return InstallationText.read("pendant installation 1\n" + lines).installation();
  }

  @BeforeEach
  void link() throws Exception {
    session =
        RobotSession.start(
            ControllerOptions.headless()
                .withInstallation(
                    installation(
                        """
                        variable name="count" value="1"
                        start-up start-input="digital_in[0]"
                        """)));
    session.setPace(new Pace.Unlimited());
    on(
        () -> {
          active.addListener(() -> changes.add(active.current()));
          var _ =
              new InstallationLink(session, active, dispatch, told::add, () -> starts.add(true));
        });
    next(changes);
    // an edge before the first frame is none
    CountDownLatch seen = new CountDownLatch(1);
    session.addFrameListener(state -> seen.countDown());
    seen.await();
  }

  @AfterEach
  void close() {
    session.close();
    dispatch.shutdownNow();
  }

  private void on(Runnable task) throws Exception {
    dispatch.submit(task).get(30, TimeUnit.SECONDS);
  }

  private static <T> T next(BlockingQueue<T> queue) throws InterruptedException {
    T next = queue.poll(30, TimeUnit.SECONDS);
    assertTrue(next != null, "nothing came");
    return next;
  }

  private Reply ask(Command command) throws Exception {
    return session.submit(command).get(30, TimeUnit.SECONDS);
  }

  private void run(String text) throws Exception {
    Program program = TestController.program(session.robot(), text);
    assertInstanceOf(Reply.Done.class, session.run(program).get(30, TimeUnit.SECONDS));
  }

  /** Waits for frames until the controller has a TCP of that name. */
  private void awaitTool(String name) throws InterruptedException {
    BlockingQueue<String> tools = new LinkedBlockingQueue<>();
    session.addFrameListener(
        state -> {
          if (state.arm().tool().name().equals(name)) {
            tools.add(name);
          }
        });
    next(tools);
  }

  @Test
  void theDesktopBeginsWithWhatTheControllerIsSetUpAs() {
    assertEquals("1", active.current().variables().getFirst().value());
  }

  @Test
  void aChangeReachesTheController() throws Exception {
    on(() -> active.set(installation(TOOL)));
    awaitTool("Gripper");
  }

  @Test
  void aChangeWaitsForTheEndOfTheProgram() throws Exception {
    run("def f():\n  sleep(1e9)\nend\n");
    on(() -> active.set(installation(TOOL)));
    assertTrue(
        next(told).startsWith("The controller is not set up anew yet: program f runs"), "told");
    ask(new ProgramCommand.StopProgram());
    awaitTool("Gripper");
  }

  @Test
  void valuesThatAProgramLeavesComeBack() throws Exception {
    run("def f():\n  global count = 7\nend\n");
    assertEquals("7", next(changes).variables().getFirst().value());
  }

  @Test
  void whatAClientLoadsIsTakenOver() throws Exception {
    Installation loaded = installation(TOOL);
    ask(new InstallationCommand.ApplyInstallation(loaded));
    assertEquals(loaded, next(changes));
  }

  @Test
  void anotherControllerIsSetUpTheSame() throws Exception {
    on(() -> active.set(installation(TOOL)));
    awaitTool("Gripper");
    session.restart(ControllerOptions.headless());
    awaitTool("Gripper");
  }

  @Test
  void anEdgeOfTheInputStartsTheProgramInFront() throws Exception {
    ask(new IoCommand.SetInput("digital_in[0]", true));
    assertTrue(next(starts));
  }
}
