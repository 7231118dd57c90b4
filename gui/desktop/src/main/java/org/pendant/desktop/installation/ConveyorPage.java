package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Conveyor page: conveyors that programs can follow. */
final class ConveyorPage implements Page {
  private static final List<String> DECODERS =
      List.of(
          text("decoderOff"),
          text("quadrature"),
          text("risingAndFallingEdges"),
          text("risingEdges"),
          text("fallingEdges"));

  /** Number of configurable_in[0] for the decoder. */
  private static final int FIRST = 8;

  private static final List<List<Integer>> PAIRS =
      List.of(List.of(8, 9), List.of(10, 11), List.of(9, 8), List.of(11, 10));

  private final TitledCard card = new TitledCard("conveyors", text("conveyors"), "[grow, fill]");
  private final Items<ConveyorSetup> items;
  private final JLabel count = new JLabel(" ");

  ConveyorPage(Editing editing) {
    items =
        new Items<>(
            "conveyor",
            text("conveyors"),
            text("noConveyorYetAConveyorGoes"),
            new Listed<>(editing, Installation::conveyors, (parts, all) -> parts.conveyors = all),
            each -> text("conveyorAlong", each.number(), each.feature()));
    items.adder("add-conveyor", text("addConveyor"), () -> fresh(editing.now()));
    PartsForm<ConveyorSetup> form = items.form();
    form.<Integer>choice(
            "number",
            text("number"),
            now -> List.of(1, 2),
            String::valueOf,
            ConveyorSetup::number,
            (c, number) -> with(c, number, c.encoder(), c.feature(), c.circular()))
        .<Integer>choice(
            "encoder",
            text("encoder"),
            now -> List.of(0, 1),
            String::valueOf,
            ConveyorSetup::encoder,
            (c, encoder) -> with(c, c.number(), encoder, c.feature(), c.circular()))
        .add(text("countsNow"), count)
        .<String>choice(
            "feature",
            text("feature"),
            now -> features(editing.now()),
            name -> name,
            ConveyorSetup::feature,
            (c, feature) -> with(c, c.number(), c.encoder(), feature, c.circular()))
        .check(
            "circular",
            text("circular"),
            ConveyorSetup::circular,
            (c, circular) -> with(c, c.number(), c.encoder(), c.feature(), circular))
        .check(
            "tool-turns-with-it",
            text("toolTurnsWithIt"),
            ConveyorSetup::rotateTool,
            (c, rotate) ->
                new ConveyorSetup(
                    c.number(),
                    c.encoder(),
                    c.feature(),
                    c.circular(),
                    c.ticksPerUnit(),
                    rotate,
                    c.decoder(),
                    c.inputs()))
        .numberRow(
            "ticks-per-m-or-turn",
            text("ticksPerMOrTurn"),
            Measure.PLAIN,
            ConveyorSetup::ticksPerUnit,
            (c, ticks) ->
                new ConveyorSetup(
                    c.number(),
                    c.encoder(),
                    c.feature(),
                    c.circular(),
                    ticks,
                    c.rotateTool(),
                    c.decoder(),
                    c.inputs()))
        .<Integer>choice(
            "pulses",
            text("pulses"),
            now -> IntStream.range(0, DECODERS.size()).boxed().toList(),
            DECODERS::get,
            ConveyorSetup::decoder,
            (c, type) -> decoded(c, type, inputs(type, c.inputs())))
        .<List<Integer>>choice(
            "at-inputs",
            text("atInputs"),
            now -> choices(now.decoder()),
            ConveyorPage::words,
            ConveyorSetup::inputs,
            (c, inputs) -> decoded(c, c.decoder(), inputs))
        .note(text("configurableInputsNote"));
    card.add(items.component());
    count.setName("conveyor-count");
  }

  private static ConveyorSetup fresh(Installation now) {
    boolean firstTaken = now.conveyors().stream().anyMatch(each -> each.number() == 1);
    String feature = now.features().stream().findFirst().map(Feature::name).orElse("");
    return new ConveyorSetup(
        firstTaken ? 2 : 1,
        firstTaken ? 1 : 0,
        feature,
        false,
        1000,
        false,
        1,
        firstTaken ? List.of(10, 11) : List.of(8, 9));
  }

  private static ConveyorSetup with(
      ConveyorSetup c, int number, int encoder, String feature, boolean circular) {
    return new ConveyorSetup(
        number,
        encoder,
        feature,
        circular,
        c.ticksPerUnit(),
        c.rotateTool(),
        c.decoder(),
        c.inputs());
  }

  private static ConveyorSetup decoded(ConveyorSetup c, int type, List<Integer> inputs) {
    return new ConveyorSetup(
        c.number(),
        c.encoder(),
        c.feature(),
        c.circular(),
        c.ticksPerUnit(),
        c.rotateTool(),
        type,
        inputs);
  }

  private static List<Integer> inputs(int type, List<Integer> before) {
    List<List<Integer>> choices = choices(type);
    return choices.contains(before)
        ? before
        : choices.stream()
            .filter(each -> !each.isEmpty() && before.contains(each.getFirst()))
            .findFirst()
            .orElse(choices.getFirst());
  }

  private static List<List<Integer>> choices(int type) {
    return switch (type) {
      case 0 -> List.of(List.of());
      case 1 -> PAIRS;
      default -> List.of(List.of(8), List.of(9), List.of(10), List.of(11));
    };
  }

  private static String words(List<Integer> inputs) {
    List<String> names = inputs.stream().map(each -> "CI " + (each - FIRST)).toList();
    return switch (names.size()) {
      case 0 -> text("noInputs");
      case 1 -> names.getFirst();
      default -> text("bothInputs", names.getFirst(), names.getLast());
    };
  }

  private static List<String> features(Installation installation) {
    List<String> names = new ArrayList<>();
    installation.features().forEach(each -> names.add(each.name()));
    return names;
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    items.show();
  }

  @Override
  public void refresh(ControllerState state) {
    Encoders.Counts counts = state.encoders();
    String words =
        items
            .chosen()
            .map(each -> each.encoder() == 0 ? counts.first() : counts.second())
            .map(ticks -> text("ticks", ticks))
            .orElse(" ");
    if (!words.equals(count.getText())) {
      count.setText(words);
    }
  }
}
