/**
 * The fields of the real-time data exchange: what clients read of a controller, what they write,
 * and who watches that they go on writing (manual 18.1, 18.2, 18.10, 18.41).
 */
package org.pendant.controller.rtde;
