package org.pendant.motion.toolpath;

import static org.pendant.motion.toolpath.ToolpathTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.motion.MotionControl;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.nc.NcFile;
import org.pendant.motion.toolpath.nc.NcPath;
import org.pendant.motion.toolpath.nc.NcReader;

/**
 * Toolpath queue: the motions that a program queues, which of them have run, and the toolpaths that
 * it has loaded (manual 20). Belongs to the frame loop.
 */
public final class Toolpaths {
  /** How far the arm may be from its path, or from where the last run has left it, m. */
  public static final double DIVERGENCE_M = 0.005;

  /** A larger file is read beside the frame loop, bytes. */
  private static final long SMALL_FILE_BYTES = 32 << 10;

  private static final long BYTES_A_FRAME = 64 << 10;
  private static final int LEGS_A_FRAME = 500;

  private static final int MAX_FILES = 64;
  private static final int MAX_LOADED_POINTS = 400_000;
  private static final int MAX_ORDERS = 20_000;

  private final ArmDescription arm;
  private final boolean virtualTime;
  private final List<Loaded> files = new ArrayList<>();
  private final List<QueuedMotion> orders = new ArrayList<>();
  private Optional<ToolConfiguration> station = Optional.empty();
  private boolean turnFree;
  private Pose pcs = Pose.ZERO;
  private double speedFactor = 1;
  private int loadedPoints;

  /** How many of the queued motions have run. */
  private int done;

  private boolean running;
  private Optional<Pose> leftAt = Optional.empty();

  /** A loaded file, and the pace that it was first queued with. */
  private static final class Loaded {
    private final NcPath path;
    private final boolean feeds;
    private Optional<Leg.Limits> pace = Optional.empty();

    Loaded(NcPath path, boolean feeds) {
      this.path = path;
      this.feeds = feeds;
    }
  }

  /**
   * Nothing queued.
   *
   * @param virtualTime whether runs must repeat exactly
   */
  public Toolpaths(ArmDescription arm, boolean virtualTime) {
    this.arm = arm;
    this.virtualTime = virtualTime;
  }

  /** Forgets everything; a new program starts. */
  public void clear() {
    files.clear();
    loadedPoints = 0;
    running = false;
    speedFactor = 1;
    station = Optional.empty();
    forgetOrders();
  }

  private void forgetOrders() {
    orders.clear();
    done = 0;
    pcs = Pose.ZERO;
    leftAt = Optional.empty();
  }

  /**
   * Begins a new sequence (manual 20.6).
   *
   * @param free whether the tool may turn about its z-axis as it likes
   */
  public void initialize(ToolConfiguration holder, boolean free) throws PlanningException {
    if (running) {
      throw new PlanningException("robot-in-use", text("running"));
    }
    forgetOrders();
    station = Optional.of(holder);
    turnFree = free;
    speedFactor = 1;
  }

  /** Who holds the tool. */
  public Optional<ToolConfiguration> station() {
    return station;
  }

  private ToolConfiguration initialized() throws PlanningException {
    return station.orElseThrow(
        () -> new PlanningException("not-initialized", text("notInitialized")));
  }

  /** Sets the part's frame for what is queued from now on (manual 20.9). */
  public void setPcs(Pose part) throws PlanningException {
    initialized();
    pcs = part;
  }

  /** The part of their speed that the motions have now, 0 to 1. */
  public double speedFactor() {
    return speedFactor;
  }

  /** Sets the part of their speed that the motions have (manual 20.10). */
  public void setSpeedFactor(double factor) {
    speedFactor = factor;
  }

  /** Queues a straight line; its number. */
  public int addLinear(Pose to, double acceleration, double speed, double radiusM)
      throws PlanningException {
    return queue(
        new QueuedMotion.Line(
            Poses.trans(pcs, to), new Leg.Limits(acceleration, speed, radiusM, false)));
  }

  /** Queues an arc; its number. */
  public int addCircular(
      Pose via, Pose to, double acceleration, double speed, double radiusM, boolean withTangent)
      throws PlanningException {
    return queue(
        new QueuedMotion.Arc(
            Poses.trans(pcs, via),
            Poses.trans(pcs, to),
            withTangent,
            new Leg.Limits(acceleration, speed, radiusM, false)));
  }

  /** Whether the feed rates of a loaded file count; empty if there is no such file. */
  public Optional<Boolean> feeds(int file) {
    return file >= 0 && file < files.size() ? Optional.of(files.get(file).feeds) : Optional.empty();
  }

  /** How many files are loaded. */
  public int loaded() {
    return files.size();
  }

  /** Whether a loaded file was queued before with another pace (manual 20.7). */
  public boolean queuedOtherwise(int file, double acceleration, double speed) {
    Optional<Leg.Limits> pace = files.get(file).pace;
    return pace.isPresent()
        && (pace.get().accelerationMPerS2() != acceleration || pace.get().speedMPerS() != speed);
  }

  /** Queues a loaded file; its number. */
  public int addPath(int file, double acceleration, double speed, double radiusM)
      throws PlanningException {
    Loaded loaded = files.get(file);
    Leg.Limits pace = new Leg.Limits(acceleration, speed, radiusM, true);
    int id = queue(new QueuedMotion.Path(loaded.path, pcs, loaded.feeds, pace));
    loaded.pace = Optional.of(pace);
    return id;
  }

  private int queue(QueuedMotion queuedMotion) throws PlanningException {
    initialized();
    if (orders.size() == MAX_ORDERS) {
      throw new PlanningException("too-many-motions", text("queueFull", MAX_ORDERS));
    }
    orders.add(queuedMotion);
    return orders.size() - 1;
  }

  /** How many motions are queued, those that have run included. */
  public int queued() {
    return orders.size();
  }

  /**
   * Reads a file, beside the frame loop.
   *
   * @param feeds whether its feed rates will count
   */
  public BackgroundTask<NcPath> load(NcFile found, boolean feeds) {
    long frames = 1 + found.sizeBytes() / BYTES_A_FRAME;
    return BackgroundTask.begin(() -> read(found, feeds), frames, virtualTime);
  }

  /** Whether a file is so small that it is read at once. */
  public static boolean small(NcFile found) {
    return found.sizeBytes() <= SMALL_FILE_BYTES;
  }

  /** Reads a file at once. */
  public static NcPath read(NcFile found, boolean feeds) throws PlanningException {
    NcPath path = NcReader.read(found.shortName(), found.read());
    if (feeds && path.points().getFirst().feedMPerS() == 0) {
      throw new PlanningException(
          "toolpath-file", text("noFeedRate", path.file(), path.points().getFirst().line()));
    }
    return path;
  }

  /** Keeps a file that has been read; its number. */
  public int keep(NcPath path, boolean feeds) throws PlanningException {
    if (files.size() == MAX_FILES || loadedPoints + path.points().size() > MAX_LOADED_POINTS) {
      throw new PlanningException(
          "toolpath-too-long", text("tooMuchLoaded", MAX_FILES, MAX_LOADED_POINTS));
    }
    loadedPoints += path.points().size();
    files.add(new Loaded(path, feeds));
    return files.size() - 1;
  }

  /**
   * The number of the last motion of a run.
   *
   * @param id as the script gives it, -1 for all
   * @return empty if all of them have run before
   * @throws PlanningException when there is no such motion, or motions are being run
   */
  public OptionalInt lastOf(int id) throws PlanningException {
    initialized();
    if (running) {
      throw new PlanningException("robot-in-use", text("otherThread"));
    }
    if (id < -1 || id >= orders.size()) {
      throw new PlanningException(
          "value-out-of-range",
          orders.isEmpty() ? text("noneQueued", id) : text("idOutside", id, orders.size() - 1));
    }
    int last = id < 0 ? orders.size() - 1 : id;
    return last < done ? OptionalInt.empty() : OptionalInt.of(last);
  }

  /**
   * Plans a run, beside the frame loop; must end in {@link #ran} or {@link #ended}.
   *
   * @param last the number of its last motion
   * @param from joint positions, rad
   * @throws PlanningException when the arm is not where the last run has left it
   */
  public BackgroundTask<RunPlan> plan(int last, Joints from, Pose activeTcp)
      throws PlanningException {
    ToolConfiguration holder = initialized();
    refuseElsewhere(holder, from);
    RunPlan.Task task =
        new RunPlan.Task(
            arm,
            holder,
            turnFree,
            orders.subList(done, last + 1),
            done,
            from,
            activeTcp,
            this::speedFactor);
    running = true;
    return BackgroundTask.begin(
        () -> RunPlan.of(task), 1 + task.legs() / LEGS_A_FRAME, virtualTime);
  }

  private void refuseElsewhere(ToolConfiguration holder, Joints from) throws PlanningException {
    Pose now = holder.toolAt(new ForwardKinematics(arm).flangePose(from));
    if (leftAt.isPresent() && Poses.pointDistance(leftAt.get(), now) > DIVERGENCE_M) {
      throw new PlanningException(
          "path-divergence",
          text(
              "elsewhere",
              String.format(Locale.ROOT, "%.1f", 1000 * Poses.pointDistance(leftAt.get(), now)),
              done - 1,
              String.format(Locale.ROOT, "%.0f", 1000 * DIVERGENCE_M)));
    }
  }

  /** A run has come to its end. */
  public void ran(int last, RunPlan plan) {
    ended();
    done = last + 1;
    leftAt = Optional.of(plan.endInWork());
  }

  /** A run is over, at its end or not. */
  public void ended() {
    running = false;
  }

  /**
   * How far the arm is from where it should be, measured where the tool is, m.
   *
   * @param drivenRad where the joints should be, rad
   * @param actualRad where they are, rad
   */
  public double divergenceM(ForwardKinematics forward, Joints drivenRad, Joints actualRad) {
    return station
        .map(holder -> holder.apartM(forward.flangePose(drivenRad), forward.flangePose(actualRad)))
        .orElse(0.0);
  }

  /** The target speed of the tool that stands still over the part, m/s; 0 without one. */
  public double remoteSpeedMPerS(ForwardKinematics forward, MotionControl motion) {
    if (station.isEmpty() || !station.get().remote()) {
      return 0;
    }
    return RemoteSpeed.mPerS(arm, forward, motion, station.get().tcp());
  }
}
