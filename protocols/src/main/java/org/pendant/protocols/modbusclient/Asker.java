package org.pendant.protocols.modbusclient;

/** Requester: takes what a device answers. Only the thread of the device calls this. */
interface Asker {
  /** Nothing is to be asked. */
  long NEVER = Long.MAX_VALUE;

  /** In how many ns a question is due; 0 or less for now, {@link #NEVER} for none. */
  long dueInNs(long nowNs);

  /** The question that is due; an answer, an error or {@link #dropped} follows. */
  DeviceRequest ask(long nowNs);

  /** The device has answered. */
  void answered(DeviceResponse answer);

  /** The device did not answer in time. */
  void unanswered();

  /** The connection has ended before the answer. */
  void dropped();
}
