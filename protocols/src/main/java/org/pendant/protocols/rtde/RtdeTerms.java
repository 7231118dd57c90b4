package org.pendant.protocols.rtde;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.rtde.InputField;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.OutputField;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Terms;

/**
 * RTDE terms: what a client has set up so far.
 *
 * @param version of the protocol
 * @param frequencyHz of the output recipe
 * @param sending whether data packages are sent
 * @param outputs fields of the output recipe
 * @param inputs fields of each input recipe; the first has number 1
 */
public record RtdeTerms(
    int version,
    double frequencyHz,
    boolean sending,
    List<ReceivedField> outputs,
    List<List<ReceivedField>> inputs)
    implements Terms {
  /** Of a client that has just connected. */
  static final RtdeTerms NONE = new RtdeTerms(1, 0, false, List.of(), List.of());

  /** Copies the lists. */
  public RtdeTerms {
    outputs = List.copyOf(outputs);
    inputs = List.copyOf(inputs);
  }

  RtdeTerms withVersion(int now) {
    return new RtdeTerms(now, frequencyHz, sending, outputs, inputs);
  }

  RtdeTerms withSending(boolean now) {
    return new RtdeTerms(version, frequencyHz, now, outputs, inputs);
  }

  RtdeTerms withOutputs(List<ReceivedField> now, double nowHz) {
    return new RtdeTerms(version, nowHz, false, now, inputs);
  }

  RtdeTerms withOutputsOf(List<OutputField> now, double nowHz) {
    return withOutputs(
        now.stream().map(each -> new ReceivedField(each.name(), each.type())).toList(), nowHz);
  }

  RtdeTerms withInputs(List<ReceivedField> added) {
    List<List<ReceivedField>> more = new ArrayList<>(inputs);
    more.add(added);
    return new RtdeTerms(version, frequencyHz, sending, outputs, more);
  }

  RtdeTerms withInputsOf(InputRecipe added) {
    return withInputs(added.fields().stream().map(RtdeTerms::received).toList());
  }

  private static ReceivedField received(InputField field) {
    return new ReceivedField(field.name(), field.type());
  }

  @Override
  public double rateHz() {
    return sending ? frequencyHz : 0;
  }

  @Override
  public List<String> reads() {
    return outputs.stream().map(ReceivedField::name).toList();
  }

  @Override
  public List<String> writes() {
    return inputs.stream().flatMap(List::stream).map(ReceivedField::name).distinct().toList();
  }

  @Override
  public Dissector dissector() {
    return new RtdeDissector(this);
  }
}
