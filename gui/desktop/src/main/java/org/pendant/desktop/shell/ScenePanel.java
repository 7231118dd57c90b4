package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.DoubleConsumer;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.Timer;
import org.pendant.command.service.StandardView;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Contact;
import org.pendant.controller.world.MovedObject;
import org.pendant.controller.world.MovedScene;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.move.ArmPull;
import org.pendant.desktop.move.BodyPull;
import org.pendant.desktop.move.GhostArm;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.desktop.scene.DeviceSight;
import org.pendant.desktop.scene.JointFrames;
import org.pendant.desktop.scene.Lens;
import org.pendant.desktop.scene.OtherArm;
import org.pendant.desktop.scene.PayloadBall;
import org.pendant.desktop.scene.SafetySight;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.scene.TouchedAtStop;
import org.pendant.desktop.scene.Touching;
import org.pendant.desktop.scene.TraceReader;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.scene.mesh.FloorGrid;
import org.pendant.desktop.scene.view.ObjectHand;
import org.pendant.desktop.scene.view.SceneView;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.StateWords;
import org.pendant.desktop.session.StillArm;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.fault.Faults;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.recording.Recording;
import org.pendant.recording.lines.Margin;

/** Scene panel: the arm in 3D, what is around it, and where its tool has been. */
final class ScenePanel implements View, GhostArm {
  /** What goes to the menu of the bar in a narrow dock, the first one first. */
  private static final List<String> SPARED =
      List.of(
          "scene.back",
          "scene.right",
          "scene.left",
          "scene.ortho",
          "scene.frames",
          "scene.front",
          "scene.top",
          "scene.tool",
          "scene.drag");

  /** Points of the tool's way that are remembered: a minute of steady motion. */
  private static final int TRACE_POINTS = 2000;

  /** While something moves, a faster machine is given newer snapshots: 60 in a second and more. */
  private static final int MOVING_MS = 15;

  /** So long after the last change nothing moves any more. */
  private static final long REST_NS = 300_000_000;

  private final Workbench workbench;
  private final Supplier<Optional<ControllerState>> past;
  private final Supplier<Optional<Recording>> opened;
  private final SceneView picture = new SceneView();
  private final JPanel panel = new JPanel(new BorderLayout());
  private final StillArm stillArm = new StillArm();
  private final TraceReader trace;
  private final SceneShows shows;
  private final SafetyScene safety;
  private final TouchedAtStop touchedAtStop = new TouchedAtStop();
  private final ArmPull pull;
  private final BodyPull carry;
  private final CellScene cell;
  private final SceneBar bar;
  private final Timer moving = Faults.timer(MOVING_MS, this::follow);
  private Optional<Joints> ghostRad = Optional.empty();
  private WaypointMarkers waypointMarkers = WaypointMarkers.NONE;
  private List<WaypointMarkers.Mark> features = List.of();
  private Optional<Surroundings> surroundings = Optional.empty();

  /** The last scene whose objects had moved. */
  private Moved movedLast = new Moved(Scene.EMPTY, List.of(), Scene.EMPTY);

  private Optional<Seen> seen = Optional.empty();
  private Supplier<ComparedWays> compared = () -> ComparedWays.NONE;
  private Supplier<Optional<Scene>> proposed = Optional::empty;
  private Supplier<Optional<List<List<DeviceSetup>>>> proposedDevices = Optional::empty;
  private Supplier<Optional<String>> chosenDevice = Optional::empty;
  private long changedNs;

  /** An arm and what is around it: people may change both at any time. */
  private record Surroundings(ArmDescription arm, Scene scene, Touching touching) {}

  /** A scene, and the same with its objects where they were. */
  private record Moved(Scene real, List<MovedObject> objects, Scene scene) {}

  /** All that the picture depends on. */
  private record Seen(
      Surroundings surroundings,
      Joints positionRad,
      Pose toolInFlange,
      Optional<Joints> ghostRad,
      Optional<Payload> payload,
      boolean frames,
      TcpTrace trace,
      SceneTheme theme,
      WaypointMarkers waypointMarkers,
      SafetySight safety,
      Set<String> hit,
      ComparedWays compared,
      DeviceSight devices,
      List<OtherArm> others,
      DisplayUnit length) {}

  /**
   * The arm.
   *
   * @param past the moment that people look at; empty for now
   * @param opened the recording of a file that it is of; empty for none
   */
  ScenePanel(
      Workbench workbench,
      Supplier<Optional<ControllerState>> past,
      Supplier<Optional<Recording>> opened) {
    this.workbench = workbench;
    this.past = past;
    this.opened = opened;
    cell = new CellScene(workbench.session(), () -> opened.get().isPresent());
    trace =
        new TraceReader(
            TRACE_POINTS,
            state ->
                workbench.session().safety(state.safety().checksum(), state.arm().description()),
            workbench::notify);
    shows = new SceneShows(workbench.settings());
    safety = new SafetyScene(workbench.session(), shows);
    pull = new ArmPull(workbench.session()::submit, EventQueue::invokeLater);
    carry = new BodyPull(workbench.session()::submit, EventQueue::invokeLater);
    setObjectHand(ObjectHand.NONE);
    picture.setHand(new PullingHand(pull, () -> past.get().isPresent()));
    bar = bar();
    panel.add(bar, BorderLayout.NORTH);
    panel.add(picture, BorderLayout.CENTER);
  }

  private SceneBar bar() {
    SceneBar buttons = new SceneBar(workbench.actions());
    for (StandardView direction : StandardView.values()) {
      String title = title(direction);
      buttons.button(
          "scene." + direction.word(),
          StateWords.capital(title),
          text("lookFromTip", title),
          direction.key(),
          () -> picture.look(direction));
    }
    buttons.button("scene.fit", text("fit"), text("showTheWholeRobot"), text("home"), picture::fit);
    buttons.button(
        "scene.tool",
        text("tool"),
        text("lookAtTheToolFromNear"),
        text("enter"),
        picture::zoomToTool);
    buttons.toggle(
        "scene.drag",
        text("dragArm"),
        text("dragTheArmByFreedriveCtrl"),
        "",
        pull::wanted,
        pull::setWanted);
    buttons.toggle(
        "scene.ortho",
        text("ortho"),
        text("withoutPerspectiveToCompareLengths"),
        "O",
        () -> picture.lens() == Lens.ORTHOGRAPHIC,
        on -> picture.setLens(on ? Lens.ORTHOGRAPHIC : Lens.PERSPECTIVE));
    buttons.toggle(
        "scene.frames",
        text("frames"),
        text("showTheFramesOfJointsAnd"),
        "",
        shows::frames,
        shows::setFrames);
    buttons.check(
        "scene.payload", text("showThePayloadAsABall"), shows::payload, shows::setPayload);
    buttons.group(text("wayOfTheTool"), () -> addWay(buttons));
    buttons.check(
        "scene.waypoints",
        text("showTheWaypointsOfTheProgram"),
        shows::waypoints,
        shows::setWaypoints);
    buttons.check(
        "scene.features",
        text("showTheFeaturesOfTheInstallation"),
        shows::features,
        shows::setFeatures);
    buttons.group(text("safety"), () -> safety.addTo(buttons));
    buttons.entry("scene-file.open", text("openScene"));
    buttons.entry("scene-file.close", text("closeTheScene"));
    buttons.item("scene.save", text("saveThePicture"), this::save);
    return buttons.done(SPARED);
  }

  private void addWay(SceneBar buttons) {
    buttons.check("scene.trace", text("showWhereTheToolWas"), shows::trace, shows::setTrace);
    buttons.check(
        "scene.trace-elbow", text("showWhereTheElbowWasToo"), shows::elbow, shows::setElbow);
    buttons.choices(text("colourTheWayOfTheTool"), colourings());
    buttons.item("scene.clear", text("forgetWhereTheToolWas"), trace::clear);
  }

  @Override
  public String id() {
    return "scene";
  }

  @Override
  public String title() {
    return "3D";
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(Optional<Joints> goalRad) {
    ghostRad = goalRad;
  }

  /** Shows the places that a program goes to from now on. */
  void show(WaypointMarkers marks) {
    waypointMarkers = marks;
  }

  /** Tells the key of a node of the program whose place or way people click. */
  void onNode(LongConsumer listener) {
    picture.onNode(listener);
  }

  /** Tells when the tool was where people click, robot time, s. */
  void onMoment(DoubleConsumer listener) {
    picture.onMoment(listener);
  }

  /** Tells the line of the program at which the tool was where people click. */
  void onLine(IntConsumer listener) {
    picture.onLine(listener);
  }

  /** What lines of the program are called, such as {@code Line 12}. */
  void setPlaces(IntFunction<String> names) {
    picture.setPlaces(names);
  }

  /** Where to ask for safety settings that people type and have not applied yet. */
  void setProposedSafety(Supplier<Optional<SafetyConfiguration>> draft) {
    safety.setProposed(draft);
  }

  /** Where to ask for the ways of the tool in variants of a run. */
  void setCompared(Supplier<ComparedWays> ways) {
    compared = ways;
  }

  /** Places objects of the scene from now on when they are dragged, unless they are carried. */
  void setObjectHand(ObjectHand hand) {
    picture.setObjectHand(
        new CarryingHand(
            new CellHand(hand, () -> cell.seen().baseInCell()),
            carry,
            () -> past.get().isPresent(),
            pull::wanted,
            this::canMove));
  }

  /** Whether an object of that name, or a copy, has a mass and is there. */
  private boolean canMove(String name) {
    return workbench.session().state().moved().stream()
        .anyMatch(each -> each.name().equals(name) && each.there());
  }

  /** Where to ask for the scene that people change and have not applied yet. */
  void setProposedScene(Supplier<Optional<Scene>> draft) {
    proposed = draft;
  }

  /** Where to ask for the name of the device that people have chosen. */
  void setChosenDevice(Supplier<Optional<String>> chosen) {
    chosenDevice = chosen;
  }

  /** Where to ask for the devices that people change and have not applied yet. */
  void setProposedDevices(Supplier<Optional<List<List<DeviceSetup>>>> draft) {
    proposedDevices = draft;
  }

  /** Shows the features of an installation that are finished. */
  void show(List<Feature> installed) {
    List<WaypointMarkers.Mark> marks = new ArrayList<>();
    for (Feature each : installed) {
      FeaturePoses.pose(each)
          .ifPresent(pose -> marks.add(new WaypointMarkers.Mark(each.name(), pose, false, 0)));
    }
    features = List.copyOf(marks);
  }

  /** Ways go by the numbers of waypoints, so these come first. */
  private WaypointMarkers marks() {
    WaypointMarkers shown = shows.waypoints() ? waypointMarkers : WaypointMarkers.NONE;
    if (!shows.features() || features.isEmpty()) {
      return shown;
    }
    List<WaypointMarkers.Mark> all = new ArrayList<>(shown.marks());
    all.addAll(features);
    return new WaypointMarkers(all, shown.ways());
  }

  @Override
  public void refresh(ControllerState state) {
    bar.refresh();
    picture.setForm(FormMemory.read(workbench.settings()));
    see(state);
    // A hand pulls the arm where it is, whatever is shown.
    pull.take(workbench.session().state(), workbench.session().pace());
    pull.newReason().ifPresent(workbench::notify);
    carry.repeat();
    carry.newReason().ifPresent(workbench::notify);
  }

  private void follow() {
    if (!panel.isShowing() || System.nanoTime() - changedNs > REST_NS) {
      moving.stop();
    } else if (picture.hasTime()) {
      see(past.get().orElseGet(workbench.session()::state));
    }
  }

  private void see(ControllerState newest) {
    boolean back = past.get().isPresent();
    ControllerState state = stillArm.shown(cell.state(newest, back));
    Surroundings around = surroundings(state.arm().description().id(), state.moved());
    ArmState arm = state.arm();
    if (shows.trace()) {
      readTrace(newest.frame());
    }
    Seen now =
        new Seen(
            around,
            arm.actualPositionRad(),
            arm.tool().inFlange(),
            ghostRad,
            shows.payload() ? Optional.of(state.readings().payload()) : Optional.empty(),
            shows.frames(),
            shows.trace() ? trace.trace(shows.elbow(), shows.traceBy()) : TcpTrace.EMPTY,
            SceneView.colours(),
            marks(),
            safety.sight(state, arm.actualPositionRad()).andHit(cell.hitByOthers(state, back)),
            hit(state, around.scene),
            compared.get(),
            cell.devices(state, back, proposedDevices.get(), chosenDevice.get()),
            cell.others(state, back),
            FormMemory.read(workbench.settings()).length());
    if (seen.equals(Optional.of(now))) {
      return;
    }
    seen = Optional.of(now);
    changedNs = System.nanoTime();
    moving.start();
    picture.setModel(model(now, arm));
  }

  private void readTrace(long frame) {
    SessionMember seen = cell.seen();
    if (past.get().isEmpty()) {
      trace.follow(seen, seen.recording());
    } else if (opened.get().isPresent()) {
      trace.lookAt(opened.get().get(), opened.get().get(), frame);
    } else {
      trace.lookAt(seen, seen.recording(), frame);
    }
  }

  private static String title(StandardView direction) {
    return switch (direction) {
      case ISO -> text("iso");
      case FRONT -> text("front");
      case BACK -> text("back");
      case LEFT -> text("left");
      case RIGHT -> text("right");
      case TOP -> text("top");
    };
  }

  private List<SceneBar.Choice> colourings() {
    List<SceneBar.Choice> choices = new ArrayList<>();
    choices.add(colouring(text("speedOfTool"), Optional.empty()));
    for (Margin each : Margin.values()) {
      choices.add(colouring(text("margin", each.words()), Optional.of(each)));
    }
    return choices;
  }

  private SceneBar.Choice colouring(String title, Optional<Margin> margin) {
    String word = margin.map(each -> each.words().replace(' ', '-')).orElse("speed");
    return new SceneBar.Choice(
        "scene.trace-by-" + word,
        title,
        () -> shows.traceBy().equals(margin),
        () -> shows.setTraceBy(margin));
  }

  private static SceneModel model(Seen now, ArmState arm) {
    ArmDescription described = now.surroundings.arm;
    List<Pose> frames =
        now.frames ? JointFrames.of(arm.kinematics(), described.dh(), now.positionRad) : List.of();
    return new SceneModel(
        described,
        arm.kinematics(),
        now.positionRad,
        now.ghostRad,
        now.toolInFlange,
        frames,
        now.payload.flatMap(
            load -> PayloadBall.of(load, arm.kinematics().flangePose(now.positionRad))),
        now.surroundings.scene,
        touched(now, arm),
        now.trace,
        now.theme,
        now.waypointMarkers,
        now.safety,
        now.compared,
        now.devices,
        now.others,
        FloorGrid.of(now.length));
  }

  /** What the tool touches, and what it ran into when it was stopped. */
  private static Set<String> touched(Seen now, ArmState arm) {
    Set<String> touched = new HashSet<>(now.hit);
    touched.addAll(
        now.surroundings.touching.names(arm.kinematics(), now.positionRad, now.toolInFlange));
    return touched;
  }

  private Set<String> hit(ControllerState state, Scene scene) {
    return touchedAtStop.of(state, scene).stream()
        .map(Contact::object)
        .collect(Collectors.toUnmodifiableSet());
  }

  private Surroundings surroundings(String id, List<MovedObject> moved) {
    Scene real = cell.real();
    // what is proposed as it is already is shown as it moves
    Scene scene =
        proposed
            .get()
            .filter(each -> !cell.isReal(each))
            .map(cell::seenFromBase)
            .orElseGet(() -> movedScene(real, moved));
    boolean otherArm = surroundings.isEmpty() || !surroundings.get().arm.id().equals(id);
    if (otherArm || !surroundings.get().scene.equals(scene)) {
      ArmDescription arm = otherArm ? ArmLibrary.load(id) : surroundings.get().arm;
      surroundings = Optional.of(new Surroundings(arm, scene, new Touching(scene)));
    }
    return surroundings.get();
  }

  /** The scene with its objects where they are; the same one while none moves. */
  private Scene movedScene(Scene real, List<MovedObject> moved) {
    if (!movedLast.real.equals(real) || !movedLast.objects.equals(moved)) {
      movedLast = new Moved(real, moved, MovedScene.of(real, moved));
    }
    return movedLast.scene;
  }

  private void save() {
    CompletableFuture<Optional<BufferedImage>> photo = picture.photo();
    SaveDialog.open(
        panel,
        new SaveRequest(
            text("saveThePictureTitle"),
            workbench.exportFile(workbench.session().options().robotId() + ".png"),
            List.of("png"),
            workbench.openFiles()),
        file -> write(photo, file),
        workbench::notify);
  }

  private static void write(CompletableFuture<Optional<BufferedImage>> photo, Path file)
      throws IOException {
    BufferedImage image =
        photo.join().orElseThrow(() -> new IOException(text("thereIsNoPictureOnThis")));
    AtomicFile.write(file, out -> ImageIO.write(image, "png", out));
  }
}
