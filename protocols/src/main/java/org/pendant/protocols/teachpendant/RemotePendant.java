package org.pendant.protocols.teachpendant;

import static org.pendant.protocols.teachpendant.TeachPendantTexts.text;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.pendant.controller.Deadline;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.Popup;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.ByteText;
import org.pendant.project.installation.file.LoadedInstallation;
import org.pendant.project.program.file.TreeFile;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.protocols.externalcontrol.ScriptRequest;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Remote pendant: the teach pendant of one control box without a screen. Any thread may use it that
 * may wait: most methods return when their action is done. A refusal gives its reason, and has
 * changed nothing.
 */
public final class RemotePendant {
  /** A frame takes 2 ms: a box that has not answered by then stands still. */
  private static final Duration PATIENCE = Duration.ofSeconds(2);

  /** How long a pause may take to come about before it is called under way. */
  private static final long PAUSE_NS = TimeUnit.MILLISECONDS.toNanos(800);

  /** More remarks about an installation are of no use in a log. */
  private static final int MAX_REMARKS = 20;

  private final Robot robot;
  private final PendantSetup setup;
  private final Identity identity;
  private final ProgramRepository programRepository;
  private final ProgramStore store;
  private final Reports reports;

  /** One change of the program at a time. */
  private final ReentrantLock changing = new ReentrantLock();

  /** A start and a stop one after the other, so that the stop is never before what it stops. */
  private final ReentrantLock beginning = new ReentrantLock();

  /** A client has asked for a stop since {@link #play} began. */
  private volatile boolean stopped;

  private volatile Optional<LoadedProgram> loaded = Optional.empty();
  private volatile String installation = "default";

  /** The installation for which the loaded program was made; guarded by {@code changing}. */
  private Installation madeFor = Installation.NONE;

  /** A driver that is asked for a part of the program that is about to start. */
  private volatile Optional<ScriptRequest> asked = Optional.empty();

  /** The last program that was started with what a driver has sent. */
  private volatile Optional<DrivenProgram> driven = Optional.empty();

  private volatile OperationalMode mode = OperationalMode.NONE;

  /** A pendant without a loaded program. */
  public RemotePendant(Robot robot, PendantSetup setup) {
    this.robot = robot;
    this.setup = setup;
    identity = Identity.of(setup.robotId());
    programRepository = new ProgramRepository(setup.programs(), robot);
    store = new ProgramStore(setup.programs(), programRepository);
    reports = new Reports(robot, setup, this::loaded);
  }

  /** What stands on the type plate. */
  public Identity identity() {
    return identity;
  }

  /** What it belongs to. */
  public PendantSetup setup() {
    return setup;
  }

  /** The newest snapshot of the controller. */
  public ControllerState state() {
    return robot.state();
  }

  /** Files with what there is to know about the box. */
  public Reports reports() {
    return reports;
  }

  /** The program that {@link #play} starts. Programs that others upload do not change it. */
  public Optional<LoadedProgram> loaded() {
    return loaded;
  }

  /** Name of the loaded installation. */
  public String installation() {
    return installation;
  }

  /**
   * Loads a program of the programs folder, and the installation that it names if that is there; a
   * program that runs is stopped.
   *
   * @param name bytes, one {@code char} a byte
   */
  public LoadedProgram load(String name) throws LoadTrouble {
    cancelStart();
    changing.lock();
    try {
      LoadedProgram found = programRepository.load(name);
      if (running()) {
        var _ = ask(new ProgramCommand.StopProgram());
      }
      loaded = Optional.of(found);
      installation = found.installation().isEmpty() ? installation : found.installation();
      setUp(found);
      madeFor = robot.installation();
      return found;
    } finally {
      changing.unlock();
    }
  }

  /**
   * As {@link #load}, also by the name of a file without its ending.
   *
   * @param name bytes, one {@code char} a byte
   */
  public LoadedProgram loadNamed(String name) throws LoadTrouble {
    if (ProgramFile.isProgram(name)) {
      return load(name);
    }
    for (String ending : ProgramFile.ENDINGS) {
      try {
        return load(name + ending);
      } catch (LoadTrouble e) {
        if (!e.missing()) {
          throw e;
        }
      }
    }
    throw new LoadTrouble(
        true, text("notThereWithAnyEnding", name, String.join(", ", ProgramFile.ENDINGS)));
  }

  /**
   * The programs that stand in the programs folder itself, by name.
   *
   * @throws IOException if the folder cannot be read
   */
  public List<ProgramFile> programs() throws IOException {
    return programRepository.programs();
  }

  /** Where clients put programs of PolyScope X, and get them from. */
  public ProgramStore store() {
    return store;
  }

  private void setUp(LoadedProgram program) {
    if (program.setup().isEmpty() || program.setup().get().equals(robot.installation())) {
      return;
    }
    ask(new InstallationCommand.ApplyInstallation(program.setup().get()))
        .complaint()
        .ifPresent(
            why ->
                log(
                    Level.WARNING,
                    text("installationNotSet", ByteText.asBytes(program.installation()), why)));
  }

  /**
   * Loads an installation of the programs folder and sets the controller up with it. Refused while
   * a program runs or the arm moves; where the safety configuration differs the arm is powered off.
   *
   * @param name bytes, one {@code char} a byte
   */
  public void loadInstallation(String name) throws LoadTrouble {
    changing.lock();
    try {
      LoadedInstallation found = programRepository.installation(name);
      Optional<String> refusal =
          ask(new InstallationCommand.ApplyInstallation(found.installation())).complaint();
      if (refusal.isPresent()) {
        throw new LoadTrouble(false, name + ": " + refusal.get());
      }
      installation = programRepository.nameOf(name);
      found.remarks().stream()
          .limit(MAX_REMARKS)
          .forEach(each -> log(Level.INFO, ByteText.asBytes(text("installationRemark", each))));
    } finally {
      changing.unlock();
    }
  }

  /**
   * Loads the program that the installation names for the start, if it names one; one that cannot
   * be loaded is told in the log.
   */
  public void loadAtStart() {
    String program = robot.installation().startUp().program();
    if (program.isEmpty()) {
      return;
    }
    try {
      var _ = load(ByteText.asBytes(program));
    } catch (LoadTrouble e) {
      log(Level.WARNING, text("notLoadedAtStart", program, e.getMessage()));
    }
  }

  /**
   * Starts the loaded program, or continues with one that is paused. One with External Control
   * nodes waits for the driver, for 10 s at most.
   */
  public Reply play() {
    changing.lock();
    try {
      stopped = false;
      return switch (state().program().state()) {
        case RUNNING -> refused(text("programRunsAlready", state().program().name()));
        case PAUSED -> ask(new ProgramCommand.ResumeProgram());
        case STOPPED ->
            loaded.isPresent() ? start(loaded.get()) : refused(text("noProgramIsLoaded"));
      };
    } finally {
      changing.unlock();
    }
  }

  /** A program tree begins with what programs have left in the installation's variables. */
  private Reply start(LoadedProgram program) {
    Installation now = robot.installation();
    if (!now.equals(madeFor)) {
      try {
        loaded = Optional.of(programRepository.renewed(program));
        madeFor = now;
      } catch (LoadTrouble e) {
        return refused(e.getMessage());
      }
    }
    LoadedProgram ready = loaded.orElseThrow();
    return ready.program().isPresent() ? begin(ready.program().get()) : startWithDriver(ready);
  }

  /** Starts a program, unless a client has asked for a stop meanwhile. */
  private Reply begin(Program program) {
    beginning.lock();
    try {
      return stopped
          ? refused(text("stoppedBeforeItBegan"))
          : ask(new ProgramCommand.StartProgram(program));
    } finally {
      beginning.unlock();
    }
  }

  private static Reply refused(String text) {
    return new Reply.Refused(Refusal.Code.PROGRAM, text);
  }

  private Reply startWithDriver(LoadedProgram program) {
    TreeFile tree = program.tree().orElseThrow();
    ScriptRequest request = setup.drivers().request(tree.installation(), tree.waitingNodes());
    // known before a driver is asked: a stop may come at once
    asked = Optional.of(request);
    try {
      if (stopped) {
        request.cancel();
      }
      DrivenProgram whole = programRepository.driven(program, request.begin().await());
      driven = Optional.of(whole);
      return begin(whole.program());
    } catch (NoScript | LoadTrouble e) {
      return refused(e.getMessage());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Reply.Busy(text("interrupted"));
    } finally {
      asked = Optional.empty();
    }
  }

  /**
   * Which line of what a driver has sent a line of the program is, in words.
   *
   * @param source name of the program's text
   */
  public Optional<String> receivedAt(String source, int line) {
    return driven.flatMap(each -> each.receivedAt(source, line));
  }

  /** A start that waits for a driver comes to nothing. */
  private void cancelStart() {
    stopped = true;
    asked.ifPresent(ScriptRequest::cancel);
  }

  /** Pauses the program and waits until it stands. */
  public Reply pause() {
    try (StateStream.Subscription frames = robot.feed().follow()) {
      Reply reply = ask(new ProgramCommand.PauseProgram());
      long begunNs = System.nanoTime();
      while (reply.complaint().isEmpty()
          && state().program().state() == ProgramState.RUNNING
          && System.nanoTime() - begunNs < PAUSE_NS) {
        var _ = frames.take();
      }
      return reply;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Reply.Busy(text("interrupted"));
    }
  }

  /**
   * Stops the program, also one that is about to start; refused when there has been none and none
   * is loaded. One that has just ended by itself is no refusal: some clients end their program and
   * then make sure of it.
   */
  public Reply stop() {
    cancelStart();
    beginning.lock();
    try {
      return running() || loaded.isPresent() || state().program().ending().isPresent()
          ? ask(new ProgramCommand.StopProgram())
          : refused(text("noProgramIsLoadedOrRuns"));
    } finally {
      beginning.unlock();
    }
  }

  private boolean running() {
    return state().program().state() != ProgramState.STOPPED;
  }

  /** The chosen operational mode. */
  public OperationalMode operationalMode() {
    return mode;
  }

  /**
   * Chooses an operational mode; NONE leaves the choice to no client, as AUTOMATIC for the robot.
   */
  public void setOperationalMode(OperationalMode chosen) {
    mode = chosen;
    var _ = ask(new SafetyCommand.SetManualMode(chosen == OperationalMode.MANUAL));
    log(Level.INFO, text("operationalMode", chosen));
  }

  /**
   * Shows a popup.
   *
   * @param text bytes, one {@code char} a byte
   */
  public Reply showPopup(String text) {
    return ask(new MessageCommand.ShowPopup(text("popupTitle"), text));
  }

  /** Closes the newest popup, whatever has shown it; a program that waits for it continues. */
  public Reply closePopup() {
    List<Popup> open = state().openPopups();
    return open.isEmpty()
        ? new Reply.Refused(Refusal.Code.UNKNOWN, text("noPopupIsOpen"))
        : ask(new MessageCommand.AnswerPopup(open.getLast().number()));
  }

  /** Writes a line to the log of the controller; does not wait. */
  public void log(Level level, String text) {
    var _ = robot.submit(new MessageCommand.WriteLog(level, text));
  }

  /**
   * Has the controller carry out a command, and waits until it has. What it does not come to in
   * time is taken back, unless it ends something: a late stop is better than none.
   */
  public Reply ask(Command command) {
    return robot.ask(
        command, ends(command) ? Deadline.orLater(PATIENCE) : Deadline.orNever(PATIENCE));
  }

  private static boolean ends(Command command) {
    return command instanceof ProgramCommand.StopProgram
        || command instanceof ProgramCommand.PauseProgram
        || command instanceof SafetyCommand.PowerOff
        || command instanceof BoxCommand.ShutDown;
  }
}
