package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.models.pose.Pose;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;

final class TraceReaderTest {
  private static final int CAPACITY = 2000;

  /** A small square at full speed, again and again, with a corner each 0.2 s. */
  private static final String SQUARE =
      """
      def prog():
        movej([0, -1.2, 1.3, -1.67, -1.57, 0], a=10, v=3)
        start = get_actual_tcp_pose()
        while True:
          movel(pose_add(start, p[0.1, 0, 0, 0, 0, 0]), a=8, v=1, r=0.01)
          movel(pose_add(start, p[0.1, 0.1, 0, 0, 0, 0]), a=8, v=1, r=0.01)
          movel(pose_add(start, p[0, 0.1, 0, 0, 0, 0]), a=8, v=1, r=0.01)
          movel(start, a=8, v=1, r=0.01)
        end
      end
      """;

  private final ControllerOptions options = ControllerOptions.headless().withArm(ArmChoice.IDEAL);
  private final Controller controller = new Controller(options);
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);
  private final List<Pose> places = new ArrayList<>();
  private final List<Runnable> slow = new ArrayList<>();
  private final List<String> told = new ArrayList<>();
  private final TraceReader reader =
      new TraceReader(CAPACITY, state -> options.safety(), told::add, slow::add, Runnable::run);

  private void start() {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, SQUARE)));
  }

  private void run(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      ring.take(controller.state());
      places.add(controller.state().arm().actualTcpInBase());
    }
  }

  private void readSlow() {
    List<Runnable> all = List.copyOf(slow);
    slow.clear();
    all.forEach(Runnable::run);
  }

  private TcpTrace trace() {
    return reader.trace(false, Optional.empty());
  }

  private void follow() {
    reader.follow(controller, ring.recording());
  }

  /** As {@link #follow}, with all that takes long. */
  private void followWhole() {
    follow();
    readSlow();
  }

  /** How far the farthest place that the tool passed in some frames is from the lines, m. */
  private double farthestM(int from, int to, TcpTrace trace) {
    double farthestM = 0;
    for (Pose place : places.subList(from, to)) {
      double nearestM = Double.MAX_VALUE;
      for (int i = 1; i < trace.size(); i++) {
        Vector3d begin = new Vector3d(trace.x(i - 1), trace.y(i - 1), trace.z(i - 1));
        Vector3d way = new Vector3d(trace.x(i), trace.y(i), trace.z(i)).sub(begin);
        Vector3d at = new Vector3d(place.x(), place.y(), place.z()).sub(begin);
        double share = Math.clamp(at.dot(way) / way.lengthSquared(), 0, 1);
        nearestM = Math.min(nearestM, at.sub(way.mul(share)).length());
      }
      farthestM = Math.max(farthestM, nearestM);
    }
    return farthestM;
  }

  @Test
  void cornersAreDrawnAsTheyWereHoweverRarelyItIsLookedAt() {
    start();
    follow();
    for (int picture = 0; picture < 10; picture++) {
      run(200);
      follow();
    }

    TcpTrace trace = trace();

    double farthestM = farthestM(0, places.size(), trace);
    assertTrue(farthestM < 6e-4, "farthest from the line: " + farthestM);
    assertTrue(trace.size() < 800, "points of 4 s: " + trace.size());
  }

  @Test
  void whatHappenedWhileNobodyLookedIsReadOutsideOfTheThreadThatAsks() {
    start();
    run(50);
    follow();
    TcpTrace before = trace();
    run(2000);
    follow();
    assertEquals(1, slow.size());
    assertSame(before, trace(), "the one before is shown meanwhile");
    follow();
    assertEquals(1, slow.size(), "nothing else is read meanwhile");

    readSlow();

    assertTrue(farthestM(0, places.size(), trace()) < 6e-4);
    run(10);
    follow();
    assertTrue(farthestM(0, places.size(), trace()) < 6e-4, "and goes on from there");
  }

  @Test
  void aMomentInWhatIsShownLeavesItAsItIs() {
    start();
    run(400);
    followWhole();
    TcpTrace now = trace();
    run(50);

    reader.lookAt(controller, ring.recording(), 100);

    assertSame(now, trace());
    followWhole();
    assertTrue(farthestM(0, places.size(), trace()) < 6e-4, "nothing is missing when one is back");
  }

  @Test
  void aMomentOfAnotherRecordingShowsWhereTheArmWasAroundIt() {
    start();
    run(400);
    Recording file = ring.recording();
    Controller other = new Controller(options);
    RecordingRing now = new RecordingRing(other.state(), other::programSource);
    reader.follow(other, now.recording());

    reader.lookAt(file, file, 200);
    assertEquals(0, trace().size(), "nothing of another arm is shown meanwhile");
    readSlow();

    assertTrue(farthestM(0, 400, trace()) < 6e-4);
    TcpTrace shown = trace();
    reader.lookAt(file, file, 210);
    assertSame(shown, trace());
    reader.follow(other, now.recording());
    assertEquals(1, trace().size(), "an arm that has not moved");
  }

  @Test
  void anOldMomentHasWhatWasBeforeAndAfterItWithinTheBound() {
    TraceReader few =
        new TraceReader(60, state -> options.safety(), told::add, slow::add, Runnable::run);
    start();
    run(2000);
    few.follow(controller, ring.recording());
    readSlow();
    double liveFromS = few.trace(false, Optional.empty()).timeS(0);
    assertTrue(liveFromS > 2, "the oldest is forgotten: " + liveFromS);

    few.lookAt(controller, ring.recording(), 700);
    readSlow();

    TcpTrace around = few.trace(false, Optional.empty());
    assertTrue(around.size() <= 60);
    assertTrue(around.timeS(0) < 1.4, "before: " + around.timeS(0));
    double lastS = around.timeS(around.size() - 1);
    assertTrue(lastS > 1.4 && lastS < liveFromS + 1, "after: " + lastS);
  }

  @Test
  void whatPeopleForgetStaysForgottenWhenAnotherControllerGoesOnFromThere() {
    start();
    run(300);
    followWhole();
    reader.clear();
    follow();
    run(50);
    follow();
    int size = trace().size();
    assertTrue(trace().timeS(0) >= 0.6, "the oldest: " + trace().timeS(0));

    reader.follow(new Object(), ring.recording());

    assertEquals(size, trace().size());
    assertTrue(size > 2, "points since then: " + size);
  }

  @Test
  void forgettingInThePastShowsNothingOfThatStretch() {
    start();
    run(300);
    followWhole();
    reader.lookAt(controller, ring.recording(), 200);
    reader.clear();
    reader.lookAt(controller, ring.recording(), 200);
    reader.lookAt(controller, ring.recording(), 150);
    readSlow();

    assertEquals(0, trace().size());
  }

  @Test
  void whatTheRecordingHasForgottenIsNoLine() {
    RecordingRing small = new RecordingRing(controller.state(), controller::programSource, 1 << 20);
    start();
    for (int i = 0; i < 100; i++) {
      controller.advance();
      small.take(controller.state());
    }
    reader.follow(controller, small.recording());
    while (small.recording().firstFrame() < 200) {
      controller.advance();
      small.take(controller.state());
    }
    reader.follow(controller, small.recording());
    readSlow();

    TcpTrace trace = trace();
    int begins = 0;
    for (int i = 1; i < trace.size(); i++) {
      begins += trace.begins(i) ? 1 : 0;
    }
    assertEquals(1, begins);
  }
}
