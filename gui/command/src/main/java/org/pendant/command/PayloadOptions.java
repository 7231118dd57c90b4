package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.world.Vector3;
import org.pendant.recording.compare.Samples;
import org.pendant.recording.compare.StartOfRun;

/** Payload options: what the arm carries, and the controller knows of, before a program begins. */
record PayloadOptions(OptionalDouble massKg, Optional<Vector3> cogM) {
  private static final double MAX_KG = 200;
  private static final int DIGITS = 4;

  private static final Option PAYLOAD =
      Option.of("--payload", new OptionArgument.Real("KG", 0, MAX_KG, false, "kg"))
          .documented(
              "1.07",
              "mass of the payload, kg, declared and carried from the start; default the recorded"
                  + " `payload`, else that of the installation, else none");
  private static final Option COG =
      Option.text("--cog", "X,Y,Z")
          .documented(
              "0,0,0.058",
              "its centre of gravity in the flange frame, m; default the recorded `payload_cog`,"
                  + " else 0,0,0");

  static final List<Option> ALL = List.of(PAYLOAD, COG);

  /** What the command line says. */
  static PayloadOptions of(Arguments arguments) throws UsageException {
    Optional<String> cog = arguments.value(COG);
    return new PayloadOptions(
        arguments.number(PAYLOAD),
        cog.isPresent() ? Optional.of(cog(cog.get())) : Optional.empty());
  }

  private static Vector3 cog(String text) throws UsageException {
    List<Double> numbers = new ArrayList<>();
    for (String each : text.split(",", -1)) {
      OptionalDouble number = Arguments.parsed(each.strip());
      if (number.isPresent() && Double.isFinite(number.getAsDouble())) {
        numbers.add(number.getAsDouble());
      }
    }
    if (numbers.size() != 3 || text.split(",", -1).length != 3) {
      throw new UsageException(CommandTexts.text("cogMustBe", COG.name(), text));
    }
    return new Vector3(numbers.get(0), numbers.get(1), numbers.get(2));
  }

  /** With what was recorded in place of what the command line does not say. */
  PayloadOptions or(Samples recorded) {
    Optional<Vector3> recordedCog =
        StartOfRun.cogM(recorded).map(each -> new Vector3(each[0], each[1], each[2]));
    return new PayloadOptions(
        massKg.isPresent() ? massKg : StartOfRun.payloadKg(recorded), cogM.or(() -> recordedCog));
  }

  /** Whether there is a mass of which nothing says where it is. */
  boolean lacksCentre() {
    return massKg.orElse(0) > 0 && cogM.isEmpty();
  }

  /** Declares it; the arm carries what is declared unless a scene says otherwise. */
  void declareTo(Controller controller) throws UsageException {
    if (massKg.isEmpty()) {
      return;
    }
    CompletableFuture<Reply> reply =
        controller.submit(
            new ManualCommand.DeclarePayload(
                massKg.getAsDouble(), cogM.orElse(new Vector3(0, 0, 0)), Optional.empty()));
    controller.advance();
    Optional<String> refusal = reply.join().complaint();
    if (refusal.isPresent()) {
      throw new UsageException(CommandTexts.text("payloadRefused", refusal.get()));
    }
  }

  /** For people, such as {@code 1.07 kg at 0, 0, 0.058 m}. */
  String text() {
    if (massKg.isEmpty()) {
      return CommandTexts.text("notGiven");
    }
    Vector3 at = cogM.orElse(new Vector3(0, 0, 0));
    return CommandTexts.text(
        "kgAt",
        Decimal.text(massKg.getAsDouble(), DIGITS),
        Decimal.text(at.x(), DIGITS),
        Decimal.text(at.y(), DIGITS),
        Decimal.text(at.z(), DIGITS));
  }
}
