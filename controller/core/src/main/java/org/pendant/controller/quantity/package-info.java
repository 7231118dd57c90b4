/**
 * The catalogue of state quantities: every number that a snapshot has, declared once with its name,
 * unit and getter. RTDE, the fixed packages of the other ports, the Modbus image and charts are
 * made from it. Open {@link org.pendant.controller.quantity.StateQuantities} first.
 */
package org.pendant.controller.quantity;
