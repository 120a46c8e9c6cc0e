// See gz/sim/System.hh; the plugin is a type that is not made.
#pragma once

#define GZ_ADD_PLUGIN(Plugin, ...) template class std::unique_ptr<Plugin>;
