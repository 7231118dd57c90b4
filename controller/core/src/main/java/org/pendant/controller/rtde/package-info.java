/**
 * The fields of the real-time data exchange: what clients read of a controller and what they write
 * (manual 18.10, 18.41).
 */
package org.pendant.controller.rtde;
