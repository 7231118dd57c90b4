package org.pendant.desktop.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;

/**
 * Forcing: signals that people set by hand: what was asked for and not yet answered, and which
 * inputs are kept away from rest. One thread uses it, the one behind its executor.
 */
final class Forcing {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor executor;
  private final Consumer<String> notify;
  private final Map<Slot, SignalWrite> asked = new HashMap<>();

  /** What brings each input to rest that is not there, by its name. */
  private final Map<String, List<SignalWrite>> forced = new LinkedHashMap<>();

  /** What a write changes: a signal may have a level and a domain. */
  private record Slot(Class<?> kind, String name) {
    static Slot of(SignalWrite write) {
      return new Slot(write.getClass(), write.name());
    }
  }

  /**
   * Nothing is forced.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   * @param notify tells people why something was refused
   */
  Forcing(
      Function<Command, CompletableFuture<Reply>> submit,
      Executor executor,
      Consumer<String> notify) {
    this.submit = submit;
    this.executor = executor;
    this.notify = notify;
  }

  /** Asks for a change. */
  void write(SignalWrite write) {
    boolean before = forced(write.name());
    mark(write);
    CompletableFuture<Reply> reply = submit.apply(new IoCommand.WriteSignals(write));
    var _ =
        reply.thenAcceptAsync(
            answer -> {
              if (answer.complaint().isPresent() && !before) {
                forced.remove(write.name());
              }
            },
            executor);
    show(write, reply);
  }

  /** Shows a change that was asked for until the controller has answered. */
  void show(SignalWrite write, CompletableFuture<Reply> reply) {
    asked.put(Slot.of(write), write);
    var _ =
        reply.thenAcceptAsync(
            answer -> {
              asked.remove(Slot.of(write), write);
              tell(answer);
            },
            executor);
  }

  private void mark(SignalWrite write) {
    List<SignalWrite> rest = rest(write);
    if (rest.contains(write)) {
      forced.remove(write.name());
    } else if (!rest.isEmpty()) {
      forced.put(write.name(), rest);
    }
  }

  /** What an input that is not forced has; none for what is no input. */
  private static List<SignalWrite> rest(SignalWrite write) {
    if (!write.input()) {
      return List.of();
    }
    return switch (write) {
      case SignalWrite.Digital set -> List.of(new SignalWrite.Digital(set.signal(), false));
      case SignalWrite.AnalogInput set -> {
        List<SignalWrite> both = new ArrayList<>();
        for (AnalogDomain domain : AnalogDomain.values()) {
          both.add(new SignalWrite.AnalogInput(set.bank(), set.index(), domain.low(), domain));
        }
        yield both;
      }
      case SignalWrite.BooleanRegister set ->
          List.of(new SignalWrite.BooleanRegister(RegisterDirection.INPUT, set.address(), false));
      case SignalWrite.IntegerRegister set ->
          List.of(new SignalWrite.IntegerRegister(RegisterDirection.INPUT, set.address(), 0));
      case SignalWrite.FloatRegister set ->
          List.of(new SignalWrite.FloatRegister(RegisterDirection.INPUT, set.address(), 0));
      case SignalWrite.PortRegister set ->
          List.of(new SignalWrite.PortRegister(set.address(), (short) 0));
      case SignalWrite.PortBit set -> List.of(new SignalWrite.PortBit(set.address(), false));
      case SignalWrite.AnalogOutput set -> List.of();
      case SignalWrite.Domain set -> List.of();
      case SignalWrite.ToolVoltage set -> List.of();
      case SignalWrite.ToolOutputs set -> List.of();
      case SignalWrite.ToolPin set -> List.of();
    };
  }

  /** The change of this kind to this signal that waits for an answer. */
  <W extends SignalWrite> Optional<W> asked(Class<W> kind, String name) {
    return Optional.ofNullable(kind.cast(asked.get(new Slot(kind, name))));
  }

  /** Whether an input was set away from rest by hand. */
  boolean forced(String name) {
    return forced.containsKey(name);
  }

  /** How many inputs are. */
  int count() {
    return forced.size();
  }

  /** Brings all of them to rest. */
  void releaseAll() {
    List<SignalWrite> writes = forced.values().stream().flatMap(List::stream).toList();
    if (writes.isEmpty()) {
      return;
    }
    Map<String, List<SignalWrite>> before = Map.copyOf(forced);
    forced.clear();
    var _ =
        submit
            .apply(new IoCommand.WriteSignals(InputOwners.BY_HAND, writes))
            .thenAcceptAsync(
                answer -> {
                  if (answer.complaint().isPresent()) {
                    before.forEach(forced::putIfAbsent);
                  }
                  tell(answer);
                },
                executor);
  }

  /** Another controller has been switched on. */
  void forget() {
    asked.clear();
    forced.clear();
  }

  private void tell(Reply reply) {
    reply.complaint().ifPresent(notify);
  }
}
