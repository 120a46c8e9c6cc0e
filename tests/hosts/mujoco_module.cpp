// Replaces MuJoCo's own Python module, which distributions do not ship, for
// libcontact.mujoco: the same names and signatures, on the installed library.
#include <mujoco/mujoco.h>
#include <pybind11/numpy.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style>;

struct Model {
  explicit Model(const std::string& path) {
    char error[500] = "";
    of.reset(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
    if (!of) throw std::runtime_error(error);
  }
  std::unique_ptr<mjModel, void (*)(mjModel*)> of{nullptr, mj_deleteModel};
  mjModel* get() const { return of.get(); }
};

struct Data {
  explicit Data(const Model& model)
      : m(model.get()), of(mj_makeData(m), mj_deleteData) {}
  const mjModel* m;
  std::unique_ptr<mjData, void (*)(mjData*)> of;
  mjData* get() const { return of.get(); }
};

// A view of numbers that the owner has.
template <class Number>
py::array view(const py::object& owner, Number* numbers, int rows,
               int columns = 0) {
  const std::vector<int> shape =
      columns ? std::vector<int>{rows, columns} : std::vector<int>{rows};
  return py::array_t<Number>(shape, numbers, owner);
}

template <class Class, class Member>
void add_view(Class& type, const char* name, const Member& member) {
  type.def_property_readonly(name, [member](const py::object& self) {
    return member(self, self.cast<typename Class::type&>());
  });
}

void bind_model(py::module_& m) {
  py::class_<mjOption>(m, "MjOption")
      .def_readwrite("timestep", &mjOption::timestep)
      .def_readwrite("integrator", &mjOption::integrator)
      .def_readwrite("enableflags", &mjOption::enableflags);
  py::class_<Model> type(m, "MjModel");
  type.def_static("from_xml_path",
                  [](const std::string& path) { return Model(path); })
      .def_property_readonly(
          "opt", [](const Model& a) -> mjOption& { return a.get()->opt; },
          py::return_value_policy::reference_internal)
      .def_property_readonly("nv", [](const Model& a) { return a.get()->nv; });
#define MODEL_VIEW(name, size)                                       \
  add_view(type, #name, [](const py::object& self, const Model& a) { \
    return view(self, a.get()->name, a.get()->size);                 \
  })
  MODEL_VIEW(jnt_type, njnt);
  MODEL_VIEW(jnt_dofadr, njnt);
  MODEL_VIEW(jnt_qposadr, njnt);
  MODEL_VIEW(jnt_bodyid, njnt);
  MODEL_VIEW(body_parentid, nbody);
  MODEL_VIEW(dof_damping, nv);
  MODEL_VIEW(dof_frictionloss, nv);
#undef MODEL_VIEW
}

void bind_data(py::module_& m) {
  py::class_<Data> type(m, "MjData");
  type.def(py::init<const Model&>(), py::keep_alive<1, 2>())
      .def_property_readonly("time",
                             [](const Data& d) { return d.get()->time; })
      .def_property_readonly("nefc",
                             [](const Data& d) { return d.get()->nefc; });
#define DATA_VIEW(name, ...)                                        \
  add_view(type, #name, [](const py::object& self, const Data& d) { \
    return view(self, d.get()->name, __VA_ARGS__);                  \
  })
  DATA_VIEW(qpos, d.m->nq);
  DATA_VIEW(qvel, d.m->nv);
  DATA_VIEW(qacc, d.m->nv);
  DATA_VIEW(qacc_smooth, d.m->nv);
  DATA_VIEW(qfrc_smooth, d.m->nv);
  DATA_VIEW(qfrc_constraint, d.m->nv);
  DATA_VIEW(qM, d.m->nM);
  DATA_VIEW(cfrc_int, d.m->nbody, 6);
  DATA_VIEW(xmat, d.m->nbody, 9);
  DATA_VIEW(xaxis, d.m->njnt, 3);
  DATA_VIEW(efc_state, d.get()->nefc);
  DATA_VIEW(efc_D, d.get()->nefc);
#undef DATA_VIEW
}

void bind_functions(py::module_& m) {
  m.def("mj_name2id", [](const Model& a, int type, const std::string& name) {
    return mj_name2id(a.get(), type, name.c_str());
  });
  m.def("mj_id2name", [](const Model& a, int type, int id) {
    return mj_id2name(a.get(), type, id);
  });
  const auto plain = [&](const char* name, auto* function) {
    m.def(name,
          [function](const Model& a, Data& d) { function(a.get(), d.get()); });
  };
  plain("mj_checkPos", mj_checkPos);
  plain("mj_checkVel", mj_checkVel);
  plain("mj_forward", mj_forward);
  plain("mj_checkAcc", mj_checkAcc);
  plain("mj_Euler", mj_Euler);
  plain("mj_rnePostConstraint", mj_rnePostConstraint);
  plain("mj_fwdConstraint", mj_fwdConstraint);
  m.def("mj_fullM", [](const Model& a, Array to, const Array& mass) {
    mj_fullM(a.get(), to.mutable_data(), mass.data());
  });
  m.def("mj_mulJacTVec",
        [](const Model& a, Data& d, Array to, const Array& by) {
          mj_mulJacTVec(a.get(), d.get(), to.mutable_data(), by.data());
        });
}

}  // namespace

PYBIND11_MODULE(mujoco, m) {
  bind_model(m);
  bind_data(m);
  bind_functions(m);
}
