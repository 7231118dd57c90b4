package org.pendant.recording.compare;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.IntStream;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.recording.ReceivedRecording;
import org.pendant.recording.Recording;

/** Recorded samples: a recording of Pendant's own as samples, one a frame. */
public final class RecordedSamples {
  private RecordedSamples() {}

  /**
   * Everything in it that is worth comparing. Of a controller that was listened to these are the
   * samples that a table of the same columns has.
   */
  public static Samples of(Recording recording) {
    return recording.received() ? received(recording) : ofFrames(recording);
  }

  private static Samples received(Recording recording) {
    List<String> columns = recording.receivedColumns();
    Map<ColumnRole, Integer> places = new HashMap<>();
    for (int i = 0; i < columns.size(); i++) {
      places.putIfAbsent(ColumnRole.of(columns.get(i)), i);
    }
    List<StateQuantity> told = new ArrayList<>();
    List<Integer> order = new ArrayList<>();
    for (StateQuantity each : SampledQuantity.all()) {
      List<Integer> components =
          IntStream.range(0, each.size())
              .mapToObj(i -> places.get(new ColumnRole.Measure(each, i)))
              .filter(Objects::nonNull)
              .toList();
      if (components.size() == each.size()) {
        told.add(each);
        order.addAll(components);
      }
    }
    Samples.Builder builder = new Samples.Builder(told);
    double[] numbers = new double[order.size()];
    double[] originS = {Double.NaN};
    recording.receivedRows(
        row -> {
          double timeS = row.value(ReceivedRecording.TIME);
          if (Double.isNaN(originS[0])) {
            originS[0] = timeS;
          }
          for (int i = 0; i < numbers.length; i++) {
            numbers[i] = row.value(order.get(i));
          }
          if (builder.rows() == 0 || timeS - originS[0] > builder.lastS()) {
            builder.add(timeS - originS[0], numbers);
          }
        });
    return builder.build();
  }

  private static Samples ofFrames(Recording recording) {
    Samples.Builder builder = new Samples.Builder(SampledQuantity.all());
    for (long frame = recording.firstFrame(); frame <= recording.lastFrame(); frame++) {
      builder.add(recording.atFrame(frame));
    }
    return builder.build();
  }
}
