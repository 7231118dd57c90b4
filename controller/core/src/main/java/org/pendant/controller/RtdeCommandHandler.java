package org.pendant.controller;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.rtde.ControlAssembly;
import org.pendant.controller.rtde.InputField;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.controller.rtde.RtdeCommand;

/** Handler of what RTDE clients write: signals, the speed slider, forces, watchdogs. */
final class RtdeCommandHandler implements CommandHandler<RtdeCommand> {
  private final ControlBox box;

  RtdeCommandHandler(ControlBox box) {
    this.box = box;
  }

  @Override
  public Class<RtdeCommand> family() {
    return RtdeCommand.class;
  }

  @Override
  public Reply carryOut(RtdeCommand command) {
    return switch (command) {
      case RtdeCommand.WriteInputs(String writer, InputUpdate update) ->
          Reply.unless(writeFromOutside(writer, update));
      case RtdeCommand.ClaimInputs claim -> {
        claim.answer().accept(claim(claim.owner(), claim.recipe()));
        yield Reply.done();
      }
    };
  }

  private Optional<Refusal> writeFromOutside(String writer, InputUpdate update) {
    Optional<Refusal> refusal = write(writer, update);
    if (refusal.isEmpty() && update.recipe().equals(ControlAssembly.RECIPE)) {
      box.links().assemblies().writtenFromOutside();
    }
    return refusal;
  }

  /** Writes what a client asks for, unless another one has some of it. */
  Optional<Refusal> write(String writer, InputUpdate update) {
    InputOwners owners = box.signals().owners();
    for (String claim : update.recipe().claims()) {
      if (!owners.mayWrite(claim, writer)) {
        return owners.refusal(claim, writer);
      }
    }
    update.writes().forEach(box.signals()::write);
    update.speedFraction().ifPresent(box.motion()::setSpeedFraction);
    update.externalWrench().ifPresent(box.flange()::readExternalForceSensor);
    box.links().inputWatchdogs().received(update.recipe().names(), box.clock().timeS());
    return Optional.empty();
  }

  /** Takes all inputs of a recipe, unless another client has some of them, which are answered. */
  private Set<String> claim(String owner, InputRecipe recipe) {
    InputOwners owners = box.signals().owners();
    Set<String> inUse =
        recipe.fields().stream()
            .filter(
                field -> !field.claims().stream().allMatch(each -> owners.mayWrite(each, owner)))
            .map(InputField::name)
            .collect(Collectors.toUnmodifiableSet());
    if (inUse.isEmpty()) {
      recipe.claims().forEach(each -> owners.claim(each, owner));
    }
    return inUse;
  }
}
