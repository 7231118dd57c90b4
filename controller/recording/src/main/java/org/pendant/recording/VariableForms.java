package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.script.value.Value;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/** Forms of variables. What has not changed since the last sample of a block is not repeated. */
final class VariableForms {
  static final Form<VariableSamples> SAMPLES =
      new Form<>() {
        @Override
        void write(VariableSamples value, ByteSink out) {
          VariableSamples before = out.samplesBefore(value);
          out.whole(value.run());
          writeEach(value.globals(), before.globals(), out);
          out.text(value.mainFunction());
          writeEach(value.locals(), before.locals(), out);
          out.whole(value.omitted());
        }

        @Override
        VariableSamples read(ByteSource in) throws MalformedBytes {
          VariableSamples before = in.samplesBefore();
          VariableSamples now =
              new VariableSamples(
                  in.whole(),
                  readEach(before.globals(), in),
                  in.text(),
                  readEach(before.locals(), in),
                  in.integer());
          in.keep(now);
          return now;
        }
      };

  static final Form<TracedVariables> TRACED =
      new Form<>() {
        @Override
        void write(TracedVariables value, ByteSink out) {
          boolean sameNames = out.tracedBefore(value.names());
          out.bool(sameNames);
          if (!sameNames) {
            out.count(value.names().size());
            value.names().forEach(out::text);
          }
          for (int i = 0; i < value.names().size(); i++) {
            out.number(value.value(i));
          }
        }

        @Override
        TracedVariables read(ByteSource in) throws MalformedBytes {
          TracedVariables before = in.tracedBefore();
          List<String> names = before.names();
          boolean sameNames = in.bool();
          if (!sameNames) {
            names = names(in);
          }
          double[] values = new double[names.size()];
          for (int i = 0; i < values.length; i++) {
            values[i] = in.number();
          }
          TracedVariables now =
              sameNames ? before.withValues(values) : TracedVariables.of(names, values);
          in.keep(now);
          return now;
        }
      };

  private static final Form<Optional<Value>> VALUE = ValueForm.ANY.optional();

  private VariableForms() {}

  private static List<String> names(ByteSource in) throws MalformedBytes {
    int count = in.count(1 + Double.BYTES);
    List<String> names = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      names.add(in.text());
    }
    return names;
  }

  private static void writeEach(
      List<VariableSample> now, List<VariableSample> before, ByteSink out) {
    out.count(now.size());
    for (int i = 0; i < now.size(); i++) {
      VariableSample each = now.get(i);
      boolean same = i < before.size() && each == before.get(i);
      out.bool(same);
      if (!same) {
        out.text(each.name());
        out.text(each.expression());
        VALUE.write(each.value(), out);
        out.count(each.length());
      }
    }
  }

  private static List<VariableSample> readEach(List<VariableSample> before, ByteSource in)
      throws MalformedBytes {
    int count = in.count(1);
    List<VariableSample> now = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      if (in.bool()) {
        if (i >= before.size()) {
          throw new MalformedBytes(text("sameAsNoVariable", i));
        }
        now.add(before.get(i));
      } else {
        now.add(
            VariableSample.of(in.text(), in.text(), VALUE.read(in), in.upTo(Integer.MAX_VALUE)));
      }
    }
    return now;
  }
}
