package org.pendant.recording.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingFile;

class TrackRecordingTest {
  private static final String GOLDEN =
      """
      Pendant golden recording, version 1
      within 0.01 deg
      0.000 at 0 -90 -90 -90 90 0
      0.102 digital_out[2] on
      0.140 at 0.026 -89.996 -89.908 -89.996 89.919 0
      0.150 configurable_out[1] on
      0.200 at 10 -90 -90 -90 90 0
      0.210 digital_out[2] off
      0.300 ends
      """;

  @TempDir private Path folder;

  private Recording recording(RunTrack track) throws IOException {
    Path file = folder.resolve("some.rec");
    TrackRecording.write(track, ArmLibrary.load("ur3e"), Files.newOutputStream(file));
    return RecordingFile.open(file).recording();
  }

  @Test
  void aTrackIsTheSameAsARecording() throws IOException, MalformedTrack {
    RunTrack track = TrackText.read(GOLDEN.getBytes(StandardCharsets.UTF_8));

    Recording recording = recording(track);

    assertEquals(0, recording.firstS());
    assertEquals(0.3, recording.lastS(), 1e-9);
    assertEquals(ArmLibrary.load("ur3e"), recording.arm());
    assertEquals(
        Optional.empty(),
        TrackComparison.first(
            RunTrack.of(recording, false),
            track,
            new TrackTolerance(OptionalDouble.of(1e-9), OptionalDouble.empty(), 0)));
  }

  @Test
  void theArmIsWhereItHadToBe() throws IOException, MalformedTrack {
    Recording recording = recording(TrackText.read(GOLDEN.getBytes(StandardCharsets.UTF_8)));

    assertEquals(
        Math.toRadians(10), recording.atFrame(100).arm().actualPositionRad().get(0), 1e-12);
  }
}
