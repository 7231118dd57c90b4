/**
 * Faults of ours: they end nothing but the piece of work that made them, and are told once. Open
 * {@link org.pendant.kit.fault.Faults} first; {@link org.pendant.kit.fault.FaultFile} keeps what
 * there is to know.
 */
package org.pendant.kit.fault;
