package org.pendant.controller.modbus;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.ModbusReading;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;

/** Modbus signal of a controller; the frame loop owns it. */
public final class ModbusSignal {
  /** How often a new signal is read or written, Hz. */
  public static final int STANDARD_HZ = 10;

  /** How long a new signal may be without an answer, s (manual 18.31). */
  public static final double STANDARD_WATCHDOG_S = 2;

  private static final int HIGH_REGISTER = 0xFFFF;

  private final String name;
  private final ModbusExchange exchange;
  private final ModbusPoint point;
  private ModbusReading reading;
  private Optional<List<Integer>> written = Optional.empty();
  private int updateHz = STANDARD_HZ;
  private double watchdogS = STANDARD_WATCHDOG_S;
  private InputAction action = InputAction.DEFAULT;
  private RunStateAction runState = RunStateAction.PRESERVE;
  private long successes;
  private double lastSuccessS;
  private boolean changed = true;

  ModbusSignal(String name, ModbusExchange exchange, ModbusPoint point, double timeS) {
    this.name = name;
    this.exchange = exchange;
    this.point = point;
    reading = point.reading();
    lastSuccessS = timeS;
  }

  /** What programs call it. */
  public String name() {
    return name;
  }

  /** What it reads and writes. */
  public ModbusExchange exchange() {
    return exchange;
  }

  /** What is known of it in this frame. */
  public ModbusReading reading() {
    return reading;
  }

  /** Looks what has come since the last frame; answers whether that is something new. */
  boolean step(double timeS) {
    long now = point.successes();
    if (now != successes) {
      successes = now;
      lastSuccessS = timeS;
    }
    ModbusReading newest = point.reading();
    boolean different = !newest.equals(reading);
    reading = newest;
    changed |= different;
    return different;
  }

  /** Whether {@link #state} differs from what it was when this was asked last. */
  boolean takeChanged() {
    boolean was = changed;
    changed = false;
    return was;
  }

  /** What an output is set to, or what was read last; bits as 0 and 1. */
  public List<Integer> values() {
    return exchange.kind().readWhereWritten() ? written.orElse(reading.values()) : reading.values();
  }

  /**
   * Sets an output.
   *
   * @param first the first values; those that follow stay as they were
   */
  public void set(List<Integer> first) {
    List<Integer> all = new ArrayList<>(first);
    List<Integer> before =
        written.orElseGet(
            () ->
                exchange.kind().readWhereWritten()
                    ? reading.values()
                    : Collections.nCopies(exchange.writeCount(), 0));
    all.addAll(before.subList(first.size(), before.size()));
    List<Integer> values = List.copyOf(all);
    written = Optional.of(values);
    changed = true;
    point.write(values);
  }

  /** Sets all bits or registers of an output to one end of their range. */
  void setAll(boolean high) {
    int level = exchange.kind().digital() ? 1 : HIGH_REGISTER;
    set(Collections.nCopies(exchange.writeCount(), high ? level : 0));
  }

  /** How often the device is asked, Hz; 0 for on demand. */
  public int updateHz() {
    return updateHz;
  }

  /** Changes how often the device is asked, Hz; 0 for on demand. */
  public void setUpdateHz(int frequencyHz) {
    updateHz = frequencyHz;
    changed = true;
    point.setFrequency(frequencyHz);
  }

  /** Has the device asked once. */
  public void update() {
    point.update();
  }

  /** Changes how long it may be without an answer, s. */
  public void setWatchdogS(double timeoutS) {
    watchdogS = timeoutS;
  }

  /** How long it has not been valid, s; 0 when it is (manual 18.28). */
  public double invalidS(double timeS) {
    return reading.valid() ? 0 : timeS - lastSuccessS;
  }

  /** Whether it has not been valid for longer than its watchdog allows. */
  public boolean lost(double timeS) {
    return !reading.valid() && invalidS(timeS) > watchdogS;
  }

  /** Changes what it does by itself when it is high. */
  public void setAction(InputAction chosen) {
    action = chosen;
  }

  boolean freedriveDemanded(double timeS) {
    return action == InputAction.FREEDRIVE && reading.values().contains(1) && !lost(timeS);
  }

  void chooseRunState(RunStateAction chosen) {
    runState = chosen;
  }

  RunStateAction runState() {
    return runState;
  }

  ModbusPoint point() {
    return point;
  }

  ModbusSignalState state() {
    return new ModbusSignalState(
        name,
        exchange,
        updateHz,
        values(),
        reading.valid(),
        reading.deviceError(),
        reading.connectionError());
  }
}
