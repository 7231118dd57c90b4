package org.pendant.recording.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;

final class JointTrackTest {
  private static Joints turned(double baseRad) {
    return new Joints(baseRad, -1, -1, -1, 1, 0);
  }

  private static JointTrack track(long frames, int max) {
    JointTrack.Builder builder = new JointTrack.Builder(100, max);
    for (long frame = 100; frame <= 100 + frames; frame++) {
      builder.add(frame, turned(frame * 0.001));
    }
    return builder.track();
  }

  private static double baseRad(JointTrack track, long frame) {
    return track.at(frame).orElseThrow().get(0);
  }

  @Test
  void framesBetweenTwoPositionsAreBetweenThem() {
    JointTrack track = track(50, 100);
    assertEquals(0.1, baseRad(track, 100), 1e-6);
    assertEquals(0.123, baseRad(track, 123), 1e-6);
  }

  @Test
  void beforeItBeginsThereIsNoneAndAfterItsEndTheArmStays() {
    JointTrack track = track(50, 100);
    assertEquals(Optional.empty(), track.at(99));
    assertEquals(0.15, baseRad(track, 100_000), 1e-6);
    assertEquals(Optional.empty(), JointTrack.NONE.at(100));
  }

  @Test
  void aLongOneIsThinned() {
    JointTrack track = track(1000, 8);
    assertEquals(0.7, baseRad(track, 700), 0.081);
    assertEquals(0.1, baseRad(track, 100), 1e-6);
  }
}
