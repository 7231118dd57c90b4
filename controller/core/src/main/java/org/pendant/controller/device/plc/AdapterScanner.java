package org.pendant.controller.device.plc;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalLine;
import org.pendant.models.json.Range;
import org.pendant.models.time.FrameTime;

/**
 * Adapter scanner: a PLC that keeps a connection with cyclic data to the controller's EtherNet/IP
 * adapter, in robot time: it writes instance 112 and reads instance 100 once in each interval. The
 * frame loop owns it.
 */
public final class AdapterScanner {
  /** Boolean registers that a fieldbus has. */
  private static final int BITS = 64;

  /** Integer registers that a fieldbus has, the lower half. */
  private static final int WORDS = 24;

  private static final Range WORD = new Range(Integer.MIN_VALUE, Integer.MAX_VALUE, "");
  private static final double PERCENT = 100;

  private static final SignalGroup IN_BITS = settable("input_boolean_register", BITS);
  private static final SignalGroup IN_WORDS =
      new SignalGroup("input_integer_register", 0, WORDS, true, WORD);
  private static final SignalGroup SPEED_MASK = settable("speed_slider_mask", 1);
  private static final SignalGroup SPEED =
      new SignalGroup("speed_slider", 0, 1, true, new Range(0, PERCENT, "%"));
  private static final SignalGroup ONLINE = settable("online", 1);
  private static final SignalGroup CONNECTED = told("connected", 1, SignalGroup.LEVEL);
  private static final SignalGroup OUT_BITS =
      told("output_boolean_register", BITS, SignalGroup.LEVEL);
  private static final SignalGroup OUT_WORDS = told("output_integer_register", WORDS, WORD);
  private static final SignalGroup ROBOT_MODE = told("robot_mode", 1, WORD);
  private static final SignalGroup ROBOT_STATUS = told("robot_status", 4, SignalGroup.LEVEL);
  private static final SignalGroup SAFETY_MODE = told("safety_mode", 1, WORD);
  private static final SignalGroup SAFETY_STATUS = told("safety_status", 11, SignalGroup.LEVEL);

  /** What it writes, which its own program sets. */
  public static final List<SignalGroup> WRITTEN = List.of(IN_BITS, IN_WORDS, SPEED_MASK, SPEED);

  private static final List<SignalGroup> SEEN =
      List.of(
          ONLINE,
          CONNECTED,
          OUT_BITS,
          OUT_WORDS,
          ROBOT_MODE,
          ROBOT_STATUS,
          SAFETY_MODE,
          SAFETY_STATUS);

  /** All its signals. */
  public static final List<SignalGroup> GROUPS =
      Stream.concat(WRITTEN.stream(), SEEN.stream()).toList();

  /** Intervals without a packet after which a connection is lost, as scanners have it at first. */
  private static final int PATIENCE = 4;

  /** How often it asks again for a connection that was refused. */
  private static final int RETRY_FRAMES = FrameTime.FRAMES_PER_SECOND;

  private final String owner;
  private final int intervalFrames;
  private final Consumer<Notice> notices;
  private final SignalMemory written = new SignalMemory(WRITTEN);
  private final SignalMemory seen = new SignalMemory(SEEN);
  private Optional<AdapterPort> port = Optional.empty();
  private ScannerOutputs packet = new ScannerOutputs(0, List.of(), OptionalDouble.empty());
  private long packetChange = -1;
  private List<SignalGroupState> writtenState = List.of();
  private List<SignalGroupState> seenState = List.of();
  private List<SignalGroupState> state = List.of();
  private int framesToGo;
  private int silentFrames;
  private boolean refused;

  /** What people should know. */
  public sealed interface Notice {
    /** It has its connection. */
    record Connected() implements Notice {}

    /**
     * It was refused its connection.
     *
     * @param why who has what it writes
     */
    record Refused(String why) implements Notice {}

    /** It was silent for too long. */
    record TimedOut() implements Notice {}
  }

  /**
   * A scanner that is on the network.
   *
   * @param owner what others are refused with that want to write the same
   * @param intervalS between two packets, s
   */
  public AdapterScanner(String owner, double intervalS, Consumer<Notice> notices) {
    this.owner = owner;
    this.notices = notices;
    intervalFrames = (int) Math.max(1, Math.round(intervalS * FrameTime.FRAMES_PER_SECOND));
    seen.set(ONLINE.name(), 0, 1);
  }

  private static SignalGroup settable(String name, int count) {
    return new SignalGroup(name, 0, count, true, SignalGroup.LEVEL);
  }

  private static SignalGroup told(String name, int count, Range range) {
    return new SignalGroup(name, 0, count, false, range);
  }

  /** The adapter is there from now on. */
  public void reach(AdapterPort port) {
    this.port = Optional.of(port);
  }

  /** Whether it has its connection. */
  public boolean connected() {
    return seen.get(CONNECTED.name(), 0) != 0;
  }

  /** One of its signals. */
  public SignalLine line(String group, int index) {
    return (written.holds(group, index, 1) ? written : seen).line(group, index);
  }

  /** All its signals; the same list until one changes. */
  public List<SignalGroupState> state() {
    if (!written.state().equals(writtenState) || !seen.state().equals(seenState)) {
      writtenState = written.state();
      seenState = seen.state();
      state = Stream.concat(writtenState.stream(), seenState.stream()).toList();
    }
    return state;
  }

  /** Exchanges what is due, once a frame. */
  public void step() {
    if (port.isPresent()) {
      step(port.get());
    }
  }

  private void step(AdapterPort adapter) {
    if (seen.get(ONLINE.name(), 0) == 0) {
      framesToGo = 0;
      refused = false;
      waitFor(adapter);
      return;
    }
    silentFrames = 0;
    framesToGo--;
    if (framesToGo > 0) {
      return;
    }
    if (!connected()) {
      connect(adapter);
    }
    if (connected()) {
      exchange(adapter);
      framesToGo = intervalFrames;
    } else {
      framesToGo = RETRY_FRAMES;
    }
  }

  /** The adapter hears nothing of it. */
  private void waitFor(AdapterPort adapter) {
    silentFrames++;
    if (connected() && silentFrames >= PATIENCE * intervalFrames) {
      seen.set(CONNECTED.name(), 0, 0);
      notices.accept(new Notice.TimedOut());
      adapter.lost(owner);
    }
  }

  private void connect(AdapterPort adapter) {
    Optional<String> other = adapter.claim(owner);
    if (other.isEmpty()) {
      seen.set(CONNECTED.name(), 0, 1);
      notices.accept(new Notice.Connected());
    } else if (!refused) {
      notices.accept(new Notice.Refused(other.get()));
    }
    refused = other.isPresent();
  }

  private void exchange(AdapterPort adapter) {
    adapter.write(owner, packet());
    for (int i = 0; i < BITS; i++) {
      seen.set(OUT_BITS.name(), i, adapter.outputBit(i) ? 1 : 0);
    }
    for (int i = 0; i < WORDS; i++) {
      seen.set(OUT_WORDS.name(), i, adapter.outputWord(i));
    }
    seen.set(ROBOT_MODE.name(), 0, adapter.robotMode());
    seen.set(SAFETY_MODE.name(), 0, adapter.safetyMode());
    takeBits(ROBOT_STATUS, adapter.robotStatus());
    takeBits(SAFETY_STATUS, adapter.safetyStatus());
  }

  /** The same object as before while nothing of it has changed. */
  private ScannerOutputs packet() {
    if (packetChange != written.changes()) {
      packetChange = written.changes();
      long bits = 0;
      for (int i = 0; i < BITS; i++) {
        bits |= (long) written.get(IN_BITS.name(), i) << i;
      }
      List<Integer> words = new ArrayList<>();
      for (int i = 0; i < WORDS; i++) {
        words.add(written.get(IN_WORDS.name(), i));
      }
      packet = new ScannerOutputs(bits, words, speedFraction());
    }
    return packet;
  }

  private OptionalDouble speedFraction() {
    return written.get(SPEED_MASK.name(), 0) == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(written.get(SPEED.name(), 0) / PERCENT);
  }

  private void takeBits(SignalGroup group, int bits) {
    for (int i = 0; i < group.count(); i++) {
      seen.set(group.name(), i, bits >> i & 1);
    }
  }
}
