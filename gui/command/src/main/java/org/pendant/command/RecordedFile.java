package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.Gravity;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.ComparisonNotes;
import org.pendant.recording.compare.MalformedTable;
import org.pendant.recording.compare.RecordedSamples;
import org.pendant.recording.compare.SampleTable;
import org.pendant.recording.compare.Samples;
import org.pendant.recording.compare.StartOfRun;

/**
 * Recorded file: a recording that a command line names: a table of samples, or a {@code .rec}.
 *
 * @param samples with joint speeds
 * @param notes what people should know of it
 * @param recording what a {@code .rec} has besides
 */
record RecordedFile(
    String name, Samples samples, List<String> notes, Optional<Recording> recording) {
  /** How often a row of a table without times was written. */
  static final Option FREQUENCY =
      Option.of("--frequency", new OptionArgument.Real("HZ", 0, 1e6, true, "Hz"))
          .explained("--frequency.compare")
          .documented(
              "125",
              "how often a row of the table was written, Hz; only for tables that have no column of"
                  + " times");

  private static final String RECORDING = ".rec";

  /** A larger table is a mistake. */
  private static final long MAX_BYTES = 1L << 30;

  RecordedFile {
    notes = List.copyOf(notes);
  }

  /**
   * Reads it.
   *
   * @throws UsageException when it cannot be read, or is no recording
   */
  static RecordedFile read(String name, Path path, OptionalDouble frequencyHz)
      throws UsageException {
    refuseDirectory(name, path);
    try {
      if (Files.isRegularFile(path) && Files.size(path) > MAX_BYTES) {
        throw new UsageException(text("bytesAtMost", name, Files.size(path), MAX_BYTES));
      }
      return name.toLowerCase(Locale.ROOT).endsWith(RECORDING)
          ? of(name, open(name, path))
          : ofTable(name, path, frequencyHz);
    } catch (MalformedTable e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  private static RecordedFile of(String name, RecordingFile.Opened opened) throws UsageException {
    Samples samples = RecordedSamples.of(opened.recording());
    if (samples.rows() < 2) {
      throw new UsageException(text("samplesAtLeast", name, samples.rows()));
    }
    return withSpeeds(
        name, samples, opened.warning().stream().toList(), Optional.of(opened.recording()));
  }

  private static RecordedFile withSpeeds(
      String name, Samples samples, List<String> notes, Optional<Recording> recording) {
    Samples withSpeeds = StartOfRun.withSpeeds(samples);
    List<String> all = new ArrayList<>(notes);
    if (!withSpeeds.equals(samples)) {
      all.add(ComparisonNotes.speedsFromPositions());
    }
    return new RecordedFile(name, withSpeeds, all, recording);
  }

  /**
   * Opens a {@code .rec} file.
   *
   * @throws UsageException when it cannot be read, or is no recording
   */
  static RecordingFile.Opened open(String name, Path path) throws UsageException {
    refuseDirectory(name, path);
    try {
      return RecordingFile.open(path);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  /** The arm that moves in it, where that is told: in a {@code .rec}. */
  Optional<ArmDescription> arm() {
    return recording.map(Recording::arm);
  }

  /**
   * Gravity as the arm felt it at the end, where that is told: in a {@code .rec} of a controller of
   * Pendant's own.
   */
  Optional<Gravity> gravity() {
    return recording
        .filter(each -> !each.received())
        .map(each -> each.atFrame(each.lastFrame()).readings().mounting())
        .map(
            mounting ->
                new Gravity(
                    mounting.gravityXMPerS2(),
                    mounting.gravityYMPerS2(),
                    mounting.gravityZMPerS2()));
  }

  private static void refuseDirectory(String name, Path path) throws UsageException {
    if (Files.isDirectory(path)) {
      throw new UsageException(text("directoryNotRecording", name));
    }
  }

  private static RecordedFile ofTable(String name, Path path, OptionalDouble frequencyHz)
      throws IOException, MalformedTable {
    OptionalDouble periodS =
        frequencyHz.isPresent()
            ? OptionalDouble.of(1 / frequencyHz.getAsDouble())
            : OptionalDouble.empty();
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(Files.newInputStream(path), StandardCharsets.UTF_8))) {
      SampleTable.Read read = SampleTable.read(name, in, periodS);
      return withSpeeds(name, read.samples(), read.notes(), Optional.empty());
    }
  }
}
