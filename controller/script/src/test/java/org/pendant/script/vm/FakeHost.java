package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.script.function.Host;
import org.pendant.script.function.ScriptPlace;

/** A host without an arm, where nothing takes time but waits. */
final class FakeHost implements Host {
  final List<String> warnings = new ArrayList<>();

  @Override
  public void warn(String message) {
    warnings.add(message);
  }

  @Override
  public void internalError(Throwable fault) {
    throw new AssertionError("internal error", fault);
  }

  @Override
  public void placeMessagesBy(Supplier<Optional<ScriptPlace>> place) {}

  @Override
  public void programEnded() {}

  @Override
  public void pauseMotion() {}

  @Override
  public void resumeMotion() {}

  @Override
  public boolean arriving() {
    return false;
  }

  @Override
  public boolean handsOverBeforeRest() {
    return false;
  }

  @Override
  public boolean wantsLookAhead() {
    return false;
  }
}
